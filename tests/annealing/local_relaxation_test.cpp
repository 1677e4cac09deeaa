// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/local_relaxation.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "nanocarbon/annealing/fixed_bond_model.h"
#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon::annealing {
namespace {

// C2160 at rest, with two atoms pushed inwards: one at each end of the molecule.
class PushedFullerene : public testing::Test {
 protected:
  PushedFullerene() {
    graph = fixed_bond_graph(molecule);
    model.rebo2.set_graph(graph);
    minimise_fixed_bonds(model, nullptr, positions, {.max_iterations = 500, .force_tolerance = 1e-4});
    const auto lower = [&](std::size_t a, std::size_t b) { return positions[a].z() < positions[b].z(); };
    std::vector<AtomIndex> all(positions.size());
    for (AtomIndex a = 0; a < all.size(); ++a) all[a] = a;
    const auto [low, high] = std::minmax_element(all.begin(), all.end(), lower);
    pushed = {std::min(*low, *high), std::max(*low, *high)};
    at_rest = positions;
    for (const AtomIndex a : pushed) positions[a] *= 0.99;
    before = positions;
  }
  double energy_of(const std::vector<Vec3>& x) {
    std::vector<Vec3> gradient(x.size(), Vec3::Zero());
    return model.evaluate(x, gradient);
  }
  LocalRelaxation relax(ThreadTeam* team = nullptr) {
    return relax_around({.graph = graph, .contacts = model.contacts, .planes = {}}, positions, pushed, 1e-3,
                        team);
  }

  Molecule molecule = structures::fullerene(6, 6);
  std::vector<Vec3> positions = molecule.positions, at_rest, before;
  FixedBondGraph graph;
  FixedBondModel model;
  std::vector<AtomIndex> pushed;
};

TEST_F(PushedFullerene, ComesToRestWhereItWasPushed) {
  const double rest = energy_of(at_rest), strained = energy_of(before);
  ASSERT_GT(strained, rest + 0.1);
  const LocalRelaxation done = relax();
  EXPECT_EQ(done.pieces, 2u);
  EXPECT_NEAR(energy_of(positions), rest, 0.01 * (strained - rest));
  for (const AtomIndex a : pushed) EXPECT_LT((positions[a] - at_rest[a]).norm(), 0.02);
}

// Within six bonds of either atom there are 1 + 3 + 6 + 9 + 12 + 15 + 18 atoms of a sheet, and somewhat less by a pentagon.
TEST_F(PushedFullerene, IsLeftAloneEverywhereElse) {
  const LocalRelaxation done = relax();
  std::size_t moved = 0;
  for (std::size_t a = 0; a < positions.size(); ++a) moved += positions[a] != before[a];
  EXPECT_EQ(moved, done.moved);
  EXPECT_LE(moved, 2u * 64);
  EXPECT_GE(moved, 2u * 50);
}

TEST_F(PushedFullerene, EachPlaceComesToTheSameWithoutTheOther) {
  relax();
  const std::vector<Vec3> both = positions;
  positions = before;
  pushed.pop_back();
  EXPECT_EQ(relax().pieces, 1u);
  EXPECT_EQ(positions[pushed.front()], both[pushed.front()]);
}

TEST_F(PushedFullerene, AnyNumberOfThreadsGivesTheSameBits) {
  relax();
  const std::vector<Vec3> one = positions;
  for (const unsigned threads : {2u, 3u}) {
    positions = before;
    ThreadTeam team(threads);
    relax(&team);
    EXPECT_EQ(positions, one);
  }
}

TEST_F(PushedFullerene, ATetherHoldsItAtItsPlanes) {
  std::vector<TangentPlane> planes;
  for (const Vec3& p : before) planes.push_back({p, p.normalized()});
  const double tether = 1000;
  relax_around({.graph = graph, .contacts = model.contacts, .planes = planes, .tether = tether}, positions,
               pushed, 1e-3);
  for (const AtomIndex a : pushed)
    EXPECT_LT(std::abs(height_above(planes[a], positions[a])), 0.3 * (before[a] - at_rest[a]).norm());
}

TEST_F(PushedFullerene, NothingIsDoneWhereForcesAreEverywhere) {
  pushed.clear();
  for (AtomIndex a = 0; a < positions.size(); a += 5) pushed.push_back(a);
  EXPECT_EQ(relax().pieces, 0u);
  EXPECT_EQ(positions, before);
}

}  // namespace
}  // namespace nanocarbon::annealing
