// SPDX-License-Identifier: GPL-2.0-or-later
// The fixed-bond model in a periodic cell.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "nanocarbon/annealing/fixed_bond_model.h"
#include "nanocarbon/annealing/geometry_check.h"
#include "nanocarbon/annealing/network_guards.h"
#include "nanocarbon/annealing/network_springs.h"
#include "nanocarbon/annealing/switching_patch.h"
#include "nanocarbon/potential/rebo2/rebo2.h"
#include "nanocarbon/structures/schwarzite.h"

namespace nanocarbon::annealing {
namespace {

Molecule shaken_p688() {
  Molecule molecule = structures::schwarzite_p688(2, 2, 2);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-0.05, 0.05);
  for (Vec3& p : molecule.positions) p += Vec3(uniform(random), uniform(random), uniform(random));
  return molecule;
}

double energy_of(const FixedBondGraph& graph, const std::vector<Vec3>& positions,
                 std::vector<Vec3>& gradient) {
  FixedBondModel model;
  model.rebo2.set_graph(graph);
  gradient.assign(positions.size(), Vec3::Zero());
  return model.evaluate(positions, gradient);
}

TEST(FixedBondsInACell, EnergyAndForcesAreThoseOfTheFullPotential) {
  const Molecule molecule = shaken_p688();
  std::vector<Vec3> gradient;
  const double energy = energy_of(fixed_bond_graph(molecule), molecule.positions, gradient);
  rebo2::Rebo2 full;
  const potential::Evaluation& expected =
      full.evaluate(molecule.positions, molecule.elements, &*molecule.cell, {});
  EXPECT_NEAR(energy, expected.energy, 1e-7 * static_cast<double>(molecule.size()));
  for (std::size_t a = 0; a < molecule.size(); ++a)
    EXPECT_LT((gradient[a] + expected.forces[a]).norm(), 1e-6);
}

TEST(FixedBondsInACell, LoopsAndSingleBondsAgree) {
  const Molecule molecule = shaken_p688();
  FixedBondRebo2 rebo2;
  rebo2.set_graph(fixed_bond_graph(molecule));
  std::vector<Vec3> one(molecule.size(), Vec3::Zero()), other = one;
  EXPECT_NEAR(rebo2.evaluate(molecule.positions, one), rebo2.evaluate_each_bond(molecule.positions, other),
              1e-6);
  for (std::size_t a = 0; a < molecule.size(); ++a) EXPECT_LT((one[a] - other[a]).norm(), 1e-6);
}

TEST(FixedBondsInACell, NothingDependsOnTheImagesThatAtomsAreGivenIn) {
  const Molecule molecule = shaken_p688();
  Molecule moved = molecule;
  for (std::size_t a = 0; a < moved.size(); ++a)
    moved.positions[a] +=
        image_shift(*moved.cell, {static_cast<int>(a % 3) - 1, static_cast<int>(a % 2), -2});
  const FixedBondGraph graph = fixed_bond_graph(molecule);
  std::vector<Vec3> gradient, gradient_moved;
  EXPECT_NEAR(energy_of(graph, molecule.positions, gradient),
              energy_of(graph, moved.positions, gradient_moved), 1e-8);
  for (std::size_t a = 0; a < moved.size(); ++a) EXPECT_LT((gradient[a] - gradient_moved[a]).norm(), 1e-8);
  const auto check = check_geometry(molecule.positions, graph),
             check_moved = check_geometry(moved.positions, graph);
  EXPECT_NEAR(check.longest_bond, check_moved.longest_bond, 1e-10);
  EXPECT_NEAR(check.closest_unbonded, check_moved.closest_unbonded, 1e-10);
}

TEST(FixedBondsInACell, GuardsAndSpringsAreSlopesOfTheirEnergies) {
  Molecule molecule = shaken_p688();
  for (Vec3& p : molecule.positions) p *= 1.25;  // bonds that guards pull on
  molecule.cell->vectors *= 1.25;
  const FixedBondGraph graph = fixed_bond_graph(molecule);
  const auto energy = [&](const std::vector<Vec3>& x, std::vector<Vec3>& g) {
    g.assign(x.size(), Vec3::Zero());
    return add_guards(graph, x, g) + add_springs(graph, x, g);
  };
  std::vector<Vec3> gradient, unused;
  energy(molecule.positions, gradient);
  for (std::size_t a = 0; a < molecule.size(); a += 37)
    for (int d = 0; d < 3; ++d) {
      std::vector<Vec3> ahead = molecule.positions, behind = molecule.positions;
      ahead[a][d] += 1e-5;
      behind[a][d] -= 1e-5;
      EXPECT_NEAR(gradient[a][d], (energy(ahead, unused) - energy(behind, unused)) / 2e-5, 1e-4);
    }
}

// A flat sheet of hexagons, in a cell, whose atoms are given in all sorts of images.
SwitchingState periodic_sheet(int cells) {
  TriangleMesh mesh;
  const double edge = 2.46, row = edge * std::sqrt(0.75);
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) mesh.points.push_back(Vec3(edge * (i + 0.5 * j), row * j, 0));
  Cell cell;
  cell.vectors << cells * edge, 0.5 * cells * edge, 0, 0, cells * row, 0, 0, 0, 50;
  cell.periodic = {true, true, false};
  mesh.space = Space(cell);
  const auto at = [&](int i, int j) { return static_cast<VertexIndex>(j % cells * cells + i % cells); };
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      mesh.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  SwitchingState state;
  state.network = trivalent_network(mesh);
  state.space = mesh.space;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = corners_of(mesh, mesh.triangles[t]);
    const Vec3 shift = image_shift(cell, {static_cast<int>(t % 3) - 1, static_cast<int>(t % 5) - 2, 0});
    state.positions.push_back((a + b + c) / 3 + shift);
    state.planes.push_back({state.positions.back(), Vec3::UnitZ()});
  }
  return state;
}

TEST(SwitchesInACell, AreTheSameWhereverTheyAreMade) {
  for (const int cells : {9, 5}) {  // the patch reaches round the smaller one
    const SwitchingState state = periodic_sheet(cells);
    std::vector<double> splits, flips;
    for (RingIndex ring = 0; ring < state.network.rings.size(); ++ring) {
      for (unsigned first = 0; first < 6; ++first) {
        const auto edit = split_ring(state.network, ring, first, 3);
        ASSERT_TRUE(edit);
        SwitchingPatch patch;
        patch.gather(state, *edit, 3);
        patch.apply(*edit);
        splits.push_back(patch.energy());
      }
      const auto edit = flip_bond(state.network, state.network.rings[ring].atom, 0);
      ASSERT_TRUE(edit);
      SwitchingPatch patch;
      patch.gather(state, *edit, 3);
      patch.apply(*edit);
      flips.push_back(patch.energy());
    }
    const auto [least_split, most_split] = std::minmax_element(splits.begin(), splits.end());
    EXPECT_NEAR(*least_split, *most_split, 1e-6);
    const auto [least_flip, most_flip] = std::minmax_element(flips.begin(), flips.end());
    EXPECT_NEAR(*least_flip, *most_flip, 1e-6);
  }
}

// Atoms that a switch does not move are told where they were, whichever image of them it worked with.
TEST(SwitchesInACell, LeaveAtomsInTheImageThatTheyAreIn) {
  for (const int cells : {9, 5}) {
    const SwitchingState state = periodic_sheet(cells);
    for (RingIndex ring = 0; ring < state.network.rings.size(); ++ring) {
      const auto edit = flip_bond(state.network, state.network.rings[ring].atom, 0);
      ASSERT_TRUE(edit);
      SwitchingPatch patch;
      patch.gather(state, *edit, 3);
      for (std::size_t k = 0; k < patch.size(); ++k) {
        EXPECT_LT((patch.position(k) - state.positions[patch.atom(k)]).norm(), 1e-9);
        EXPECT_LT((patch.plane(k).point - state.planes[patch.atom(k)].point).norm(), 1e-9);
      }
      patch.apply(*edit);
      patch.relax_springs(20);
      patch.relax({.max_iterations = 20, .force_tolerance = 0.02});
      for (std::size_t k = 0; k < patch.size(); ++k)
        EXPECT_LT((patch.position(k) - state.positions[patch.atom(k)]).norm(), 2.0);
    }
  }
}

}  // namespace
}  // namespace nanocarbon::annealing
