// SPDX-License-Identifier: GPL-2.0-or-later
// Time of the long-range sum of AIREBO, microseconds an atom ("us/atom"), of CPU time on one thread:
//   benchmark_airebo_lj [--benchmark_repetitions=9 --benchmark_report_aggregates_only]
// "forces" and "forces, energy, virial" take new positions as a step of molecular dynamics does; "search" is
// what is done again when atoms have moved by half the inner margin, "find pairs" when by half the outer one;
// "take half list" is what is done with each list that another program makes.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include "nanocarbon/potential/airebo/lj/lj_dispatch.h"
#include "nanocarbon/potential/airebo/lj/lj_sum.h"
#include "potential/airebo/plain_lj_sum.h"

namespace nanocarbon::airebo {
namespace {

using test::LjSystem;

//! Pairs joined by up to three bonds.
NeighbourList within_three_bonds(const LjSystem& system) {
  NeighbourList bonds = neighbours_within(system.positions, system.cell_or_none(), 1.75);
  NeighbourList reached;
  reached.offsets.push_back(0);
  for (std::uint32_t i = 0; i < system.size(); ++i) {
    std::vector<Neighbour> found = {{i, {0, 0, 0}}};
    std::size_t begin = 0;
    for (int step = 0; step < 3; ++step) {
      const std::size_t end = found.size();
      for (; begin < end; ++begin) {
        const Neighbour from = found[begin];
        for (Neighbour to : bonds.of(from.atom)) {
          const bool bond_of_hydrogens = system.elements[from.atom] == Element::hydrogen &&
                                         system.elements[to.atom] == Element::hydrogen;
          for (int d = 0; d < 3; ++d) to.image[d] += from.image[d];
          if (!bond_of_hydrogens && std::find(found.begin(), found.end(), to) == found.end())
            found.push_back(to);
        }
      }
    }
    reached.neighbours.insert(reached.neighbours.end(), found.begin() + 1, found.end());
    reached.offsets.push_back(reached.neighbours.size());
  }
  return reached;
}

//! As atoms are at 300 K, about.
LjSystem finished(LjSystem system, double amplitude) {
  system = test::shaken(std::move(system), amplitude, 1);
  system.exclusions = within_three_bonds(system);
  return system;
}

//! Layers of graphene in AB stacking, periodic along x and y, and along z if there are several.
LjSystem graphite(int cells_x, int cells_y, int layers, bool periodic) {
  const double bond = 1.396, a = bond * std::sqrt(3.0), b = 3.0 * bond, apart = 3.358;
  LjSystem system;
  for (int l = 0; l < layers; ++l)
    for (int x = 0; x < cells_x; ++x)
      for (int y = 0; y < cells_y; ++y)
        for (int k = 0; k < 4; ++k) {
          const double along[] = {0.0, 0.5 * bond, 1.5 * bond, 2.0 * bond};
          system.positions.emplace_back(x * a + (k == 1 || k == 2 ? 0.5 * a : 0.0),
                                        y * b + along[k] + (l % 2) * bond, l * apart);
          system.elements.push_back(Element::carbon);
        }
  if (periodic)
    system.cell = orthogonal_cell({cells_x * a, cells_y * b, layers * apart}, {true, true, layers > 1});
  return finished(std::move(system), 0.1);
}

//! The orthorhombic crystal: two chains of two CH2 in a cell.
LjSystem polyethylene(int cells_x, int cells_y, int cells_z) {
  const Vec3 edges(7.1555, 4.9753, 2.5438);
  LjSystem system;
  const auto add = [&](Element element, const Vec3& p) {
    system.elements.push_back(element);
    system.positions.push_back(p);
  };
  for (int x = 0; x < cells_x; ++x)
    for (int y = 0; y < cells_y; ++y)
      for (int z = 0; z < cells_z; ++z)
        for (int chain = 0; chain < 2; ++chain)
          for (int unit = 0; unit < 2; ++unit) {
            const double setting = (chain == 0 ? 45.0 : 135.0) * std::numbers::pi / 180.0;
            const double side = unit == 0 ? 1.0 : -1.0;
            const Vec3 in_plane(std::cos(setting), std::sin(setting), 0.0);
            const Vec3 across(-std::sin(setting), std::cos(setting), 0.0);
            const Vec3 axis = edges.cwiseProduct(Vec3(x + 0.5 * chain, y + 0.5 * chain, z + 0.5 * unit));
            const Vec3 carbon = axis + 0.43 * side * in_plane;
            add(Element::carbon, carbon);
            for (const double s : {1.0, -1.0})
              add(Element::hydrogen, carbon + 0.64 * side * in_plane + s * 0.88 * across);
          }
  system.cell = orthogonal_cell(edges.cwiseProduct(Vec3(cells_x, cells_y, cells_z)));
  return finished(std::move(system), 0.1);
}

//! Carbon and hydrogen without order, 0.079 atoms in a cubic Angstrom.
LjSystem soup(int across) {
  const double spacing = std::cbrt(1.0 / 0.079);
  std::mt19937_64 random(5);
  LjSystem system;
  for (int x = 0; x < across; ++x)
    for (int y = 0; y < across; ++y)
      for (int z = 0; z < across; ++z) {
        system.positions.push_back(spacing * Vec3(x, y, z));
        system.elements.push_back(random() % 2 == 0 ? Element::carbon : Element::hydrogen);
      }
  system.cell = orthogonal_cell(Vec3::Constant(across * spacing));
  system = test::shaken(std::move(system), 0.6, 2);
  // As they come in memory once atoms have mixed.
  for (std::size_t i = system.size(); i-- > 1;) {
    const std::size_t j = random() % (i + 1);
    std::swap(system.positions[i], system.positions[j]);
    std::swap(system.elements[i], system.elements[j]);
  }
  return finished(std::move(system), 0.1);
}

void report(benchmark::State& state, const LjSystem& system, const LjSum& sum) {
  state.counters["us/atom"] =
      benchmark::Counter(1e-6 * static_cast<double>(system.size()) * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  std::size_t pairs = 0, slots = 0, listed = 0;
  for (const LjChunk& chunk : sum.lists().chunks) {
    for (const LjEntry entry : chunk.entries) pairs += static_cast<std::size_t>(std::popcount(entry & 15));
    slots += lj_lanes * chunk.entries.size();
    listed += lj_lanes * chunk.list.size();
  }
  const auto of_atoms = [&](std::size_t count) {
    return static_cast<double>(count) / static_cast<double>(system.size());
  };
  state.counters["pairs/atom"] = of_atoms(pairs);
  state.counters["slots/atom"] = of_atoms(slots);
  state.counters["listed/atom"] = of_atoms(listed);
}

enum class Work { forces, all, search, find, half_list };

//! The half list of an atom that another program would hand over: here of a molecule, without ghosts.
struct HalfList {
  std::vector<int> atoms, counts;
  std::vector<std::vector<int>> rows;
  std::vector<const int*> neighbours;
  std::vector<std::array<std::uint32_t, 2>> exclusions;

  explicit HalfList(const LjSystem& system) {
    const NeighbourList near = neighbours_within(system.positions, nullptr, 12.2);
    for (std::uint32_t i = 0; i < system.size(); ++i) {
      rows.emplace_back();
      for (const Neighbour& n : near.of(i))
        if (i < n.atom) rows.back().push_back(static_cast<int>(n.atom));
      for (const Neighbour& n : system.exclusions.of(i))
        if (i < n.atom) exclusions.push_back({i, n.atom});
      atoms.push_back(static_cast<int>(i));
      counts.push_back(static_cast<int>(rows.back().size()));
    }
    for (const auto& row : rows) neighbours.push_back(row.data());
  }

  LjHalfList list() const { return {atoms.size(), atoms.data(), neighbours.data(), counts.data()}; }
};

void run(benchmark::State& state, LjSystem system, Work work, LjForm form, const LjSumOptions& options) {
  LjSum sum(test::published_parameters(form), options);
  const auto find = [&] {
    sum.find_pairs(system.positions, system.elements, system.cell_or_none(), system.exclusions);
  };
  const auto half = work == Work::half_list ? std::make_unique<HalfList>(system) : nullptr;
  find();
  std::vector<Vec3> forces(system.size(), Vec3::Zero());
  double shift = work == Work::search ? 0.51 * options.inner_margin : 1e-4;
  for (auto _ : state) {
    for (std::size_t i = 0; i < system.size(); i += work == Work::search ? 1 : 7)
      system.positions[i].x() += shift;
    shift = -shift;
    if (work == Work::find) find();
    if (half)
      sum.use_half_list(half->list(), system.positions.front().data(), system.elements, half->exclusions);
    if (!sum.place(system.positions.front().data(), system.cell_or_none())) state.SkipWithError("lists");
    if (work == Work::forces || work == Work::all)
      benchmark::DoNotOptimize(
          sum.evaluate(forces.front().data(), {.energy = work == Work::all, .virial = work == Work::all}));
  }
  report(state, system, sum);
}

const int registered = [] {
  const std::pair<const char*, LjSystem> systems[] = {{"sheet 10k", graphite(64, 39, 1, false)},
                                                      {"graphite 10k", graphite(21, 12, 10, true)},
                                                      {"polyethylene 5k", polyethylene(6, 8, 9)},
                                                      {"soup 4k", soup(16)}};
  const auto add = [](const std::string& name, const LjSystem& system, Work work, LjForm form,
                      const LjSumOptions& options) {
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
      run(state, system, work, form, options);
    })->Unit(benchmark::kMillisecond);
  };
  for (const LjKernel* kernel : usable_lj_kernels()) {
    LjSumOptions options;
    options.instructions = kernel->name;
    const std::string suffix = std::string(", ") + kernel->name;
    for (const auto& [name, system] : systems) {
      const std::string start = std::string(name) + suffix;
      add(start + ", forces", system, Work::forces, LjForm::lennard_jones, options);
      add(start + ", forces, energy, virial", system, Work::all, LjForm::lennard_jones, options);
      add(start + ", morse, forces", system, Work::forces, LjForm::morse, options);
      add(start + ", search", system, Work::search, LjForm::lennard_jones, options);
      add(start + ", find pairs", system, Work::find, LjForm::lennard_jones, options);
    }
  }
  // Without their cells: a half list is that of a molecule here.
  for (const auto& [name, system] : systems) {
    LjSystem molecule = system;
    molecule.cell.reset();
    molecule.exclusions = within_three_bonds(molecule);
    add(std::string(name) + ", take half list", molecule, Work::half_list, LjForm::lennard_jones, {});
  }
  LjSumOptions one_chunk;
  one_chunk.own_lists.chunk_clusters = lj_most_clusters / 16;
  for (const auto& [name, system] : systems)
    add(std::string(name) + ", one chunk, forces", system, Work::forces, LjForm::lennard_jones, one_chunk);
  return 0;
}();

}  // namespace
}  // namespace nanocarbon::airebo
