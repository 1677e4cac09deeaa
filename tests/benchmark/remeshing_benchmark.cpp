// SPDX-License-Identifier: GPL-2.0-or-later
// Every step of the thesis's remeshing by itself, at 10,000, 50,000 and 200,000 triangles: the time for one
// triangle must not grow. Shapes are a torus whose triangles the recipe has not seen yet, and one that it has
// worked on.

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "nanocarbon/mesh/formats/load_surface.h"
#include "nanocarbon/remeshing/thesis/edge_lengths.h"
#include "nanocarbon/remeshing/thesis/local_optimiser.h"
#include "nanocarbon/remeshing/thesis/low_pass_filter.h"
#include "nanocarbon/remeshing/thesis/projection.h"
#include "nanocarbon/remeshing/thesis/stellar_pass.h"
#include "nanocarbon/remeshing/thesis/thesis_recipe.h"
#include "nanocarbon/remeshing/thesis/valence_optimiser.h"
#include "remeshing/shapes.h"
#include "support/models.h"

namespace nanocarbon {
namespace {

//! A torus of about this many triangles of uneven size, scaled to the bonds of the recipe.
TriangleMesh uneven_torus(std::int64_t triangles) {
  const int rows = static_cast<int>(std::sqrt(static_cast<double>(triangles) / 6.0));
  TriangleMesh mesh = test::torus(3.0, 1.0, 3 * rows, rows);
  mesh = test::sized(mesh, static_cast<double>(triangles));
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> jitter(-0.5, 0.5);
  for (Vec3& p : mesh.points) p += Vec3(jitter(random), jitter(random), jitter(random));
  return mesh;
}

const thesis::LengthInterval interval = thesis::edge_interval(1.2, 1.8);

thesis::StellarOptions stellar_options() {
  thesis::StellarOptions options;
  options.interval = interval;
  options.target_length = interval.mean();
  return options;
}

void per_triangle(benchmark::State& state, std::size_t triangles) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(triangles));
}

void Conversion(benchmark::State& state) {
  const TriangleMesh mesh = uneven_torus(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(thesis::to_triangulation(mesh));
  per_triangle(state, mesh.triangles.size());
}

void StellarPass(benchmark::State& state) {
  const thesis::Triangulation start = thesis::to_triangulation(uneven_torus(state.range(0)));
  for (auto _ : state) {
    state.PauseTiming();
    thesis::Triangulation mesh = start;
    state.ResumeTiming();
    benchmark::DoNotOptimize(thesis::stellar_pass(mesh, stellar_options()));
  }
  per_triangle(state, start.n_faces());
}

void ValenceOptimiser(benchmark::State& state) {
  thesis::Triangulation start = thesis::to_triangulation(uneven_torus(state.range(0)));
  thesis::stellar_pass(start, stellar_options());
  for (auto _ : state) {
    state.PauseTiming();
    thesis::Triangulation mesh = start;
    state.ResumeTiming();
    benchmark::DoNotOptimize(thesis::optimise_valences(mesh, {}));
  }
  per_triangle(state, start.n_faces());
}

void VertexStarsOf(benchmark::State& state) {
  const thesis::Triangulation mesh = thesis::to_triangulation(uneven_torus(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(thesis::vertex_stars(mesh));
  per_triangle(state, mesh.n_faces());
}

void LowPassFilter(benchmark::State& state) {
  const TriangleMesh mesh = uneven_torus(state.range(0));
  thesis::VertexStars stars = thesis::vertex_stars(thesis::to_triangulation(mesh));
  for (auto _ : state) benchmark::DoNotOptimize(thesis::low_pass_filter(stars, 2));
  per_triangle(state, mesh.triangles.size());
}

void LocalOptimiser(benchmark::State& state) {
  // As after the low-pass filter has done its work: few edges are outside.
  const TriangleMesh mesh = uneven_torus(state.range(0));
  thesis::VertexStars start = thesis::vertex_stars(thesis::to_triangulation(mesh));
  for (int i = 0; i < 3; ++i) thesis::low_pass_filter(start, 2);
  thesis::LocalOptions options;
  options.interval = interval;
  for (auto _ : state) {
    state.PauseTiming();
    thesis::VertexStars stars = start;
    state.ResumeTiming();
    benchmark::DoNotOptimize(thesis::optimise_locally(stars, options));
  }
  per_triangle(state, mesh.triangles.size());
}

void ProjectionMeshOf(benchmark::State& state) {
  const TriangleMesh mesh = uneven_torus(state.range(0));
  for (auto _ : state) thesis::ProjectionMesh{mesh};
  per_triangle(state, mesh.triangles.size());
}

void Projection(benchmark::State& state) {
  const TriangleMesh mesh = uneven_torus(state.range(0));
  const thesis::ProjectionMesh projection(mesh);
  thesis::VertexStars stars = thesis::vertex_stars(thesis::to_triangulation(mesh));
  thesis::low_pass_filter(stars, 2);
  for (auto _ : state) {
    std::vector<Vec3> points = stars.points;
    benchmark::DoNotOptimize(thesis::project_points(points, projection, 5));
  }
  per_triangle(state, mesh.triangles.size());
}

void WholeRecipe(benchmark::State& state) {
  const TriangleMesh mesh = uneven_torus(state.range(0));
  thesis::ThesisResult result;
  for (auto _ : state) result = thesis::remesh_by_thesis(mesh, {});
  per_triangle(state, result.mesh.triangles.size());
  state.counters["iterations"] = result.record.iterations;
  state.counters["outside_percent"] = result.record.edges.percent_outside();
}

void WholeRecipeOnTheBunny(benchmark::State& state) {
  if (test::models_folder().empty())
    return state.SkipWithError("set NANOCARBON_MODELS to a folder of meshes");
  const TriangleMesh mesh = test::sized(mesh::load_surface(test::models_folder() / "bunny-71k.off").mesh,
                                        static_cast<double>(state.range(0)));
  thesis::ThesisOptions options;
  options.atoms = static_cast<std::size_t>(state.range(0));
  thesis::ThesisResult result;
  for (auto _ : state) result = thesis::remesh_by_thesis(mesh, options);
  per_triangle(state, result.mesh.triangles.size());
  state.counters["iterations"] = result.record.iterations;
  state.counters["outside_percent"] = result.record.edges.percent_outside();
}

#define AT_THREE_SIZES(step) \
  BENCHMARK(step)->Arg(10000)->Arg(50000)->Arg(200000)->Unit(benchmark::kMillisecond)
AT_THREE_SIZES(Conversion);
AT_THREE_SIZES(StellarPass);
AT_THREE_SIZES(ValenceOptimiser);
AT_THREE_SIZES(VertexStarsOf);
AT_THREE_SIZES(LowPassFilter);
AT_THREE_SIZES(LocalOptimiser);
AT_THREE_SIZES(ProjectionMeshOf);
AT_THREE_SIZES(Projection);
AT_THREE_SIZES(WholeRecipe)->Iterations(1);
AT_THREE_SIZES(WholeRecipeOnTheBunny)->Iterations(1);

}  // namespace
}  // namespace nanocarbon
