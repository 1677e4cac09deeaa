// SPDX-License-Identifier: GPL-2.0-or-later
// What the tracking costs, and reading and writing.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <sstream>

#include "nanocarbon/molecule/dual.h"
#include "nanocarbon/molecule/formats/distance_warnings.h"
#include "nanocarbon/molecule/formats/lammps_data.h"
#include "nanocarbon/molecule/formats/read_molecule.h"
#include "nanocarbon/molecule/formats/xyz.h"
#include "nanocarbon/molecule/molecule_graph.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/topology/bond_graph.h"
#include "nanocarbon/topology/surface_topology.h"

namespace nanocarbon {
namespace {

// Icosahedral fullerenes of 20 n^2 atoms: 9,680, 50,000 and 200,000.
void sizes(benchmark::internal::Benchmark* b) {
  for (const int n : {22, 50, 100}) b->Arg(n);
  b->Unit(benchmark::kMillisecond);
}

void Dual(benchmark::State& state) {
  const TriangleMesh mesh = structures::icosahedral_triangulation(static_cast<int>(state.range(0)), 0);
  for (auto _ : state) benchmark::DoNotOptimize(molecule::dual(mesh));
}
BENCHMARK(Dual)->Apply(sizes);

// A flat sheet of the same number of atoms.
Molecule sheet(const benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  return structures::graphene(3 * n, 5 * n / 3);
}

void BondsWithin(benchmark::State& state) {
  const Molecule m = sheet(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(topology::bonds_within(m.positions, m.elements, &*m.cell, {}, m.bonds));
}
BENCHMARK(BondsWithin)->Apply(sizes);

void Topology(benchmark::State& state) {
  const topology::EmbeddedGraph graph = molecule::embedded_graph(sheet(state));
  for (auto _ : state) benchmark::DoNotOptimize(topology::surface_topology(graph));
}
BENCHMARK(Topology)->Apply(sizes);

void WriteLammpsData(benchmark::State& state) {
  const Molecule m = sheet(state);
  molecule::LammpsDataOptions options;
  options.atom_style = molecule::AtomStyle::full;
  for (auto _ : state) {
    std::ostringstream out;
    molecule::write_lammps_data(out, m, options);
    benchmark::DoNotOptimize(out);
  }
}
BENCHMARK(WriteLammpsData)->Apply(sizes);

template <typename Write>
void read_molecules(benchmark::State& state, const std::string& name, Write write) {
  std::ostringstream out;
  write(out, sheet(state));
  const std::string text = out.str();
  for (auto _ : state) {
    molecule::MoleculeFile file(text, name);
    benchmark::DoNotOptimize(file.next());
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * text.size()));
}

void ReadLammpsData(benchmark::State& state) {
  read_molecules(state, "sheet.data", [](std::ostream& out, const Molecule& m) {
    molecule::LammpsDataOptions options;
    options.atom_style = molecule::AtomStyle::full;
    molecule::write_lammps_data(out, m, options);
  });
}
BENCHMARK(ReadLammpsData)->Apply(sizes);

void ReadXyz(benchmark::State& state) {
  read_molecules(state, "sheet.xyz",
                 [](std::ostream& out, const Molecule& m) { molecule::write_xyz(out, m); });
}
BENCHMARK(ReadXyz)->Apply(sizes);

void ReadLammpsDump(benchmark::State& state) {
  read_molecules(state, "sheet.lammpstrj", [](std::ostream& out, const Molecule& m) {
    out << "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n"
        << m.size() << "\nITEM: BOX BOUNDS ff ff ff\n-1 1\n-1 1\n-1 1\nITEM: ATOMS id type element x y z\n";
    for (std::size_t i = 0; i < m.size(); ++i)
      out << fmt::format("{} 1 C {:g} {:g} {:g}\n", i + 1, m.positions[i].x(), m.positions[i].y(),
                         m.positions[i].z());
  });
}
BENCHMARK(ReadLammpsDump)->Apply(sizes);

void CloseAtoms(benchmark::State& state) {
  const Molecule m = sheet(state);
  for (auto _ : state) benchmark::DoNotOptimize(molecule::find_close_atoms(m, 0.5));
}
BENCHMARK(CloseAtoms)->Apply(sizes);

}  // namespace
}  // namespace nanocarbon
