// SPDX-License-Identifier: GPL-2.0-or-later
// How long it takes to say no: to load a pipe with a thin wall (cylinders of radius 1 and 0.97, 100,000 triangles), to
// find that 2,000 atoms are too few for it, and to find the next size that would do.
#include <benchmark/benchmark.h>

#include <cmath>

#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/repair/repair_surface.h"
#include "nanocarbon/remeshing/features/atoms_for_features.h"

namespace nanocarbon {
namespace {

constexpr double area_per_atom = 2.6195;  // square Angstrom
constexpr double atoms = 2000;

//! Closed: the outer and the inner cylinder and a flat ring at each end.
TriangleMesh pipe(double inner, double length, VertexIndex columns, VertexIndex rows) {
  TriangleMesh mesh;
  const auto circle = [&](double radius, double z) {
    for (VertexIndex i = 0; i < columns; ++i) {
      const double angle = 2 * M_PI * i / columns;
      mesh.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  };
  for (VertexIndex j = 0; j <= rows; ++j) circle(1, length * j / rows);
  for (VertexIndex j = 0; j <= rows; ++j) circle(inner, length * (rows - j) / rows);
  const VertexIndex circles = 2 * (rows + 1);
  for (VertexIndex j = 0; j < circles; ++j)
    for (VertexIndex i = 0; i < columns; ++i) {
      const VertexIndex a = j * columns + i, b = j * columns + (i + 1) % columns;
      const VertexIndex c = (j + 1) % circles * columns + i,
                        d = (j + 1) % circles * columns + (i + 1) % columns;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  return mesh;
}

TriangleMesh benchmark_pipe() { return pipe(0.97, 4, 200, 124); }

TriangleMesh sized(TriangleMesh mesh) {
  const double scale = std::sqrt(atoms * area_per_atom / mesh::area(mesh));
  for (Vec3& p : mesh.points) p *= scale;
  return mesh;
}

void load(benchmark::State& state) {
  const mesh::PolygonSoup soup = mesh::soup_of(benchmark_pipe());
  for (auto _ : state) benchmark::DoNotOptimize(mesh::repair_surface(soup));
}

void first_reason(benchmark::State& state) {
  const TriangleMesh surface = sized(benchmark_pipe());
  for (auto _ : state) {
    const features::FeatureReport report = features::check_features(surface);
    if (report.ok()) state.SkipWithError("the wall was not found");
  }
}

void next_size(benchmark::State& state) {
  const TriangleMesh surface = sized(benchmark_pipe());
  const features::FeatureReport report = features::check_features(surface);
  for (auto _ : state) {
    const auto found = features::atoms_for_features(surface, atoms, report);
    state.counters["atoms"] = static_cast<double>(found.atoms.value_or(0));
  }
}

BENCHMARK(load)->Unit(benchmark::kMillisecond);
BENCHMARK(first_reason)->Unit(benchmark::kMillisecond);
BENCHMARK(next_size)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nanocarbon
