// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/bond_switching.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "nanocarbon/annealing/dual_relaxation.h"
#include "nanocarbon/molecule/dual.h"
#include "support/rough_sphere.h"

namespace nanocarbon::annealing {
namespace {

constexpr double graphene = -7.3949972517;  // eV/atom, pair_style rebo

SwitchingState rough_state(int n, std::uint64_t seed, double scale, const TetherSurface& surface) {
  TriangleMesh rough = test::rough_sphere(n, seed, 1);
  for (Vec3& p : rough.points) p *= scale;
  Molecule molecule = molecule::dual(rough);
  relax_dual(molecule, surface);
  SwitchingState state;
  state.network = trivalent_network(rough);
  state.positions = molecule.positions;
  return state;
}

// Excess over graphene, eV/atom, without tether.
double excess_energy(SwitchingState& state, const TetherSurface& surface) {
  state.tether = 0;
  return relax_state(state, surface, 500, 1e-3) / static_cast<double>(state.positions.size()) - graphene;
}

// Annealing is a search by chance, and this schedule a short one: a seed now and then is left with one pair
// of a pentagon and a heptagon too many, and which seeds do depends on rounding. Most do not, so one of four
// must succeed.
TEST(AnnealBonds, ARoughSphereOf500AtomsBecomesAFullereneWithTwelvePentagons) {
  const double scale = test::scale_for(500, 4 * std::numbers::pi);
  const TetherSurface surface(test::unit_sphere(20), scale);
  bool found = false;
  for (std::uint64_t seed = 1; seed <= 4 && !found; ++seed) {
    SwitchingState state = rough_state(5, 1, scale, surface);
    anneal_bonds(
        state, surface,
        {.hot = 0.45, .cold = 0.2, .blocks = 20, .trials_per_defect = 60, .seed = seed, .threads = 2});
    const auto counts = ring_counts(state.network);
    // Every seed: rings of 5 to 7 alone, the atoms asked for, and no more than two pairs too many.
    ASSERT_LE(counts.size(), 8u);
    for (std::size_t size = 0; size < 5; ++size) ASSERT_EQ(counts[size], 0u);
    ASSERT_LE(counts[5], 14u);
    ASSERT_NEAR(static_cast<double>(state.positions.size()), 500, 10);
    // Icosahedral fullerenes are the best known: 100.35 meV at 540 atoms, and bending goes with the inverse
    // of the count.
    const double best = 0.10035 * 540 / static_cast<double>(state.positions.size());
    found = counts[5] == 12 && excess_energy(state, surface) < best + 0.005;
  }
  EXPECT_TRUE(found);
}

TEST(AnnealBonds, TheNumberOfThreadsDoesNotChangeTheMolecule) {
  const double scale = test::scale_for(180, 4 * std::numbers::pi);
  const TetherSurface surface(test::unit_sphere(10), scale);
  std::vector<SwitchingState> results;
  for (const unsigned threads : {1u, 3u}) {
    results.push_back(rough_state(3, 2, scale, surface));
    anneal_bonds(results.back(), surface,
                 {.hot = 0.4, .blocks = 3, .trials_per_defect = 20, .threads = threads});
  }
  ASSERT_EQ(results[0].positions.size(), results[1].positions.size());
  EXPECT_TRUE(results[0].positions == results[1].positions);
}

// By a number that has nothing to do with the energy.
TEST(AnnealBonds, TheBlockThatIsJudgedBestIsKept) {
  const double scale = test::scale_for(180, 4 * std::numbers::pi);
  const TetherSurface surface(test::unit_sphere(10), scale);
  SwitchingState state = rough_state(3, 2, scale, surface);
  std::vector<Vec3> best;
  double least = 1;
  int asked = 0;
  const auto judged = [&](const SwitchingState& now) {
    const double value = std::fmod(1e3 * std::abs(now.positions[0].x()), 1.0);
    ++asked;
    if (value < least) {
      least = value;
      best = now.positions;
    }
    return value + graphene * static_cast<double>(now.positions.size());
  };
  anneal_bonds(state, surface,
               {.hot = 0.4, .blocks = 6, .trials_per_defect = 20, .count_penalty = 0, .judged = judged});
  EXPECT_GT(asked, 3);
  EXPECT_TRUE(state.positions == best);
}

TEST(AnnealBonds, AroundAnAtomLeavesWhatIsFarAwayAlone) {
  const double scale = test::scale_for(1280, 4 * std::numbers::pi);
  const TetherSurface surface(test::unit_sphere(20), scale);
  SwitchingState state = rough_state(8, 1, scale, surface);
  const TrivalentNetwork before = state.network;
  const BondSwitchingResult result = anneal_bonds(
      state, surface,
      {.hot = 0.5, .cold = 0.5, .blocks = 1, .trials_per_defect = 40, .climb_share = 0, .around = {0}});
  EXPECT_GT(result.accepted, 0u);
  ASSERT_EQ(state.network.atoms.size(), before.atoms.size());
  // Ten bonds for the ring's atom, and the ring, its neighbours and theirs.
  const double near = 16 * 1.42;
  std::size_t far = 0;
  for (AtomIndex a = 0; a < before.atoms.size(); ++a) {
    if ((state.positions[a] - state.positions[0]).norm() < near) continue;
    ++far;
    EXPECT_EQ(state.network.atoms[a].neighbour, before.atoms[a].neighbour);
  }
  EXPECT_GT(far, before.atoms.size() / 4);
}

}  // namespace
}  // namespace nanocarbon::annealing
