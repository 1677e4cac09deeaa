// What the tracking costs, and reading and writing.
#include <benchmark/benchmark.h>

#include <sstream>

#include "nanocarbon/molecule/bond_graph.h"
#include "nanocarbon/molecule/dual.h"
#include "nanocarbon/molecule/embedded_graph.h"
#include "nanocarbon/molecule/lammps_data.h"
#include "nanocarbon/molecule/surface_topology.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"

namespace nanocarbon {
namespace {

// Icosahedral fullerenes of 20 n^2 atoms: 9,680, 50,000 and 200,000.
void sizes(benchmark::internal::Benchmark* b) {
  for (const int n : {22, 50, 100}) b->Arg(n);
  b->Unit(benchmark::kMillisecond);
}

void Dual(benchmark::State& state) {
  const TriangleMesh mesh = icosahedral_triangulation(static_cast<int>(state.range(0)), 0);
  for (auto _ : state) benchmark::DoNotOptimize(dual(mesh));
}
BENCHMARK(Dual)->Apply(sizes);

// A flat sheet of the same number of atoms.
Molecule sheet(const benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  return graphene(3 * n, 5 * n / 3);
}

void BondsWithin(benchmark::State& state) {
  const Molecule m = sheet(state);
  for (auto _ : state) benchmark::DoNotOptimize(bonds_within(m.positions, m.elements, &*m.cell, {}, m.bonds));
}
BENCHMARK(BondsWithin)->Apply(sizes);

void Topology(benchmark::State& state) {
  const EmbeddedGraph graph = embedded_graph(sheet(state));
  for (auto _ : state) benchmark::DoNotOptimize(surface_topology(graph));
}
BENCHMARK(Topology)->Apply(sizes);

void WriteLammpsData(benchmark::State& state) {
  const Molecule m = sheet(state);
  LammpsDataOptions options;
  options.atom_style = AtomStyle::full;
  for (auto _ : state) {
    std::ostringstream out;
    write_lammps_data(out, m, options);
    benchmark::DoNotOptimize(out);
  }
}
BENCHMARK(WriteLammpsData)->Apply(sizes);

void ReadLammpsData(benchmark::State& state) {
  std::ostringstream out;
  LammpsDataOptions options;
  options.atom_style = AtomStyle::full;
  write_lammps_data(out, sheet(state), options);
  for (auto _ : state) {
    std::istringstream in(out.str());
    benchmark::DoNotOptimize(read_lammps_data(in, "benchmark"));
  }
}
BENCHMARK(ReadLammpsData)->Apply(sizes);

}  // namespace
}  // namespace nanocarbon
