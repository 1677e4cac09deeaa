// SPDX-License-Identifier: GPL-2.0-or-later
// Cost of the default recipe and of what it spends its time on, CPU of all threads:
//   benchmark_relaxation [--benchmark_filter=draft] [--benchmark_repetitions=3
//   --benchmark_report_aggregates_only]
// "fixed bonds": one evaluation of energy and forces, us/atom, by the vector loops and bond by bond.
// "draft", "good": a torus of so many atoms from mesh to minimum, ms/atom; good takes minutes at the larger
// sizes. "good, threads": the same by one and two threads, wall time.
#include <benchmark/benchmark.h>

#include <cmath>

#include "nanocarbon/annealing/fixed_bond_rebo2.h"
#include "nanocarbon/building/build_molecule.h"
#include "nanocarbon/shapes/shapes.h"
#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon {
namespace {

void evaluate_fixed_bonds(benchmark::State& state, bool loops) {
  const int h = static_cast<int>(std::lround(std::sqrt(static_cast<double>(state.range(0)) / 60.0)));
  Molecule molecule = structures::fullerene(h, h);
  annealing::FixedBondRebo2 rebo2;
  rebo2.set_graph(annealing::fixed_bond_graph(molecule));
  std::vector<Vec3> gradient(molecule.size(), Vec3::Zero());
  for (auto _ : state)
    benchmark::DoNotOptimize(loops ? rebo2.evaluate(molecule.positions, gradient)
                                   : rebo2.evaluate_each_bond(molecule.positions, gradient));
  state.counters["us/atom"] =
      benchmark::Counter(1e-6 * static_cast<double>(molecule.size() * state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void build_torus(benchmark::State& state, Quality quality, unsigned threads) {
  const TriangleMesh torus = shapes::make_torus(3, 1.2, 0.15);
  building::BuildOptions options;
  options.size = building::AtomCount{static_cast<std::size_t>(state.range(0))};
  options.quality = quality;
  options.threads = threads;
  std::size_t atoms = 0;
  double energy = 0;
  for (auto _ : state) {
    const building::BuildResult result = building::build_molecule(torus, options);
    atoms += result.molecule.size();
    energy = result.rest->energy;
  }
  state.counters["ms/atom"] = benchmark::Counter(1e-3 * static_cast<double>(atoms),
                                                 benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["eV/atom"] = energy;
}

BENCHMARK_CAPTURE(evaluate_fixed_bonds, by_loops, true)
    ->Name("fixed bonds, loops")
    ->Arg(1000)
    ->Arg(10000)
    ->Arg(100000);
BENCHMARK_CAPTURE(evaluate_fixed_bonds, bond_by_bond, false)->Name("fixed bonds, bond by bond")->Arg(10000);
BENCHMARK_CAPTURE(build_torus, draft, Quality::draft, 1)
    ->Name("draft")
    ->Arg(2500)
    ->Arg(5000)
    ->Arg(10000)
    ->Arg(20000)
    ->Arg(40000)
    ->Unit(benchmark::kSecond)
    ->Iterations(1);
BENCHMARK_CAPTURE(build_torus, good, Quality::good, 1)
    ->Name("good")
    ->Arg(2500)
    ->Arg(5000)
    ->Arg(10000)
    ->Arg(20000)
    ->Unit(benchmark::kSecond)
    ->Iterations(1);
BENCHMARK_CAPTURE(build_torus, one_thread, Quality::good, 1)
    ->Name("good, 1 thread, wall")
    ->Arg(5000)
    ->Unit(benchmark::kSecond)
    ->Iterations(1)
    ->UseRealTime();
BENCHMARK_CAPTURE(build_torus, two_threads, Quality::good, 2)
    ->Name("good, 2 threads, wall")
    ->Arg(5000)
    ->Unit(benchmark::kSecond)
    ->Iterations(1)
    ->UseRealTime();

}  // namespace
}  // namespace nanocarbon
