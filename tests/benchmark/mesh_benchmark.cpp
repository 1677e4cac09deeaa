// SPDX-License-Identifier: GPL-2.0-or-later
// Times of the mesh room on a torus of 10k, 50k, 200k and 1M triangles. Reading is from memory.
#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "nanocarbon/mesh/formats/load_surface.h"
#include "nanocarbon/mesh/formats/read_mesh.h"
#include "nanocarbon/mesh/formats/write_mesh.h"
#include "nanocarbon/mesh/nearest_point.h"
#include "nanocarbon/mesh/repair/repair_surface.h"
#include "nanocarbon/mesh/self_intersections.h"
#include "nanocarbon/mesh/triangulate.h"
#include "support/small_meshes.h"

namespace nanocarbon {
namespace {

TriangleMesh torus_of(std::int64_t triangles) {
  const auto m = static_cast<VertexIndex>(std::sqrt(static_cast<double>(triangles) / 6.0));
  return mesh::triangulate(test::torus(3 * m, m)).mesh;
}

std::string file_of(const TriangleMesh& mesh, const std::string& name, bool text) {
  const auto path = std::filesystem::temp_directory_path() / ("nanocarbon_benchmark_" + name);
  mesh::write_mesh(path, mesh, {text, nullptr});
  std::ifstream stream(path, std::ios::binary);
  std::string contents{std::istreambuf_iterator<char>(stream), {}};
  std::filesystem::remove(path);
  return contents;
}

void read(benchmark::State& state, const std::string& name, bool text) {
  const TriangleMesh mesh = torus_of(state.range(0));
  const std::string contents = file_of(mesh, name, text);
  for (auto _ : state) benchmark::DoNotOptimize(mesh::parse_mesh(contents, name));
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(contents.size()));
}

void repair(benchmark::State& state) {
  const mesh::PolygonSoup soup = mesh::soup_of(torus_of(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(repair_surface(soup));
}

void find_self_intersections(benchmark::State& state) {
  const TriangleMesh mesh = torus_of(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(mesh::self_intersections(mesh));
}

void build_tree(benchmark::State& state) {
  const TriangleMesh mesh = torus_of(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(mesh::NearestPoint(mesh));
}

// Queries as the remesher makes them: near the surface, in no order or with a triangle nearby.
void find_nearest(benchmark::State& state, bool with_hint) {
  const TriangleMesh mesh = torus_of(state.range(0));
  const mesh::NearestPoint nearest(mesh);
  std::mt19937_64 random(1);
  std::vector<std::uint32_t> triangles(4096);
  std::vector<Vec3> queries(triangles.size());
  std::uniform_real_distribution<double> off(-0.02, 0.02);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    triangles[i] = static_cast<std::uint32_t>(random() % mesh.triangles.size());
    queries[i] = mesh.points[mesh.triangles[triangles[i]][0]] + Vec3(off(random), off(random), off(random));
  }
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(with_hint ? nearest.nearest(queries[i], triangles[i])
                                       : nearest.nearest(queries[i]));
    i = (i + 1) % queries.size();
  }
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Unit(benchmark::kMillisecond)->Arg(10'000)->Arg(50'000)->Arg(200'000)->Arg(1'000'000);
}
void query_sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Unit(benchmark::kNanosecond)->Arg(20'000)->Arg(200'000);
}

BENCHMARK_CAPTURE(read, off, "a.off", true)->Apply(sizes);
BENCHMARK_CAPTURE(read, obj, "a.obj", true)->Apply(sizes);
BENCHMARK_CAPTURE(read, ply_text, "a.ply", true)->Apply(sizes);
BENCHMARK_CAPTURE(read, ply_binary, "a.ply", false)->Apply(sizes);
BENCHMARK_CAPTURE(read, stl_text, "a.stl", true)->Apply(sizes);
BENCHMARK_CAPTURE(read, stl_binary, "a.stl", false)->Apply(sizes);
BENCHMARK(repair)->Apply(sizes);
BENCHMARK(find_self_intersections)->Apply(sizes);
BENCHMARK(build_tree)->Apply(sizes);
BENCHMARK_CAPTURE(find_nearest, anywhere, false)->Apply(query_sizes);
BENCHMARK_CAPTURE(find_nearest, with_hint, true)->Apply(query_sizes);

}  // namespace
}  // namespace nanocarbon
