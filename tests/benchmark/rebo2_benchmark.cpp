// SPDX-License-Identifier: GPL-2.0-or-later
// Time of the library's own REBO2, microseconds an atom and evaluation ("us/atom"), of CPU time:
//   benchmark_rebo2 [--benchmark_repetitions=9 --benchmark_report_aggregates_only]
// One thread. Every evaluation moves the atoms a little, as a step of molecular dynamics would.
#include <benchmark/benchmark.h>

#include "nanocarbon/potential/rebo2/rebo2.h"
#include "nanocarbon/potential/rebo2/kernels/sp2_dispatch.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "potential/rebo2/comparison_structures.h"

namespace nanocarbon {
namespace {

//! Graphene with about as many atoms as asked for, vibrating as at 300 K.
Molecule make_graphene(std::size_t atoms) {
  const double side = std::sqrt(static_cast<double>(atoms) * 2.62);
  Molecule sheet = structures::graphene_sheet(side, side);
  test::rattle(sheet, 0.08, 1);
  return sheet;
}

Molecule make_fullerene(std::size_t atoms) {
  const int h = static_cast<int>(std::lround(std::sqrt(static_cast<double>(atoms) / 60.0)));
  Molecule molecule = structures::fullerene(h, h);
  test::rattle(molecule, 0.05, 1);
  return molecule;
}

//! Takes single atoms away here and there until a share of the rest is not three-coordinated.
Molecule with_vacancies(Molecule molecule, double share) {
  const auto step = static_cast<std::size_t>(3.0 / share);
  Molecule rest;
  rest.cell = molecule.cell;
  for (std::size_t i = 0; i < molecule.size(); ++i)
    if (i % step != step / 2) {
      rest.positions.push_back(molecule.positions[i]);
      rest.elements.push_back(molecule.elements[i]);
    }
  return rest;
}

void evaluate(benchmark::State& state, const Molecule& molecule, std::string_view instructions,
              bool general_only) {
  rebo2::Rebo2 rebo2(rebo2::rebo2_parameters(), instructions);
  Molecule moving = molecule;
  const Cell* cell = moving.cell ? &*moving.cell : nullptr;
  double shift = 1e-4;
  rebo2.evaluate(moving.positions, moving.elements, cell);  // finds the near pairs, which all later ones keep
  for (auto _ : state) {
    for (std::size_t i = 0; i < moving.size(); i += 7) moving.positions[i].x() += shift;
    shift = -shift;
    double energy =
        rebo2.evaluate(moving.positions, moving.elements, cell, {.general_only = general_only}).energy;
    benchmark::DoNotOptimize(energy);
  }
  state.counters["us/atom"] =
      benchmark::Counter(1e-6 * static_cast<double>(moving.size()) * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["atoms"] = static_cast<double>(moving.size());
  state.counters["general"] = static_cast<double>(rebo2.general_atoms());
}

void add(const std::string& name, const Molecule& molecule, std::string_view instructions,
         bool general = false) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    evaluate(state, molecule, instructions, general);
  })->Unit(benchmark::kMillisecond);
}

const int registered = [] {
  const Molecule sheet = make_graphene(10000);
  const Molecule molecule = make_fullerene(10000);
  for (const rebo2::Sp2Kernel* kernel : rebo2::usable_sp2_kernels()) {
    const std::string suffix = std::string(", ") + kernel->name;
    add("graphene 10k" + suffix, sheet, kernel->name);
    add("fullerene 10k" + suffix, molecule, kernel->name);
    add("fullerene 10k, 5% outside" + suffix, with_vacancies(molecule, 0.05), kernel->name);
    add("graphene 200k" + suffix, make_graphene(200000), kernel->name);
  }
  add("graphene 10k, general terms only", sheet, {}, true);
  return 0;
}();

}  // namespace
}  // namespace nanocarbon
