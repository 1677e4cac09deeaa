// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/annealed_starts.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/rough_sphere.h"

namespace nanocarbon::building {
namespace {

constexpr std::size_t atoms = 1280;  // 20 * 8^2, and a quarter of them is 20 * 4^2

// A sphere with room for so many atoms.
TriangleMesh sphere(std::size_t count) {
  TriangleMesh surface = test::unit_sphere(16);
  rescale(surface, test::scale_for(count, 4 * std::numbers::pi));
  return surface;
}

// The dual of a triangulation of the unit sphere, relaxed on a sphere for so many atoms.
annealing::AnnealingLevel level_of(TriangleMesh triangulation, std::size_t count) {
  rescale(triangulation, test::scale_for(count, 4 * std::numbers::pi));
  annealing::AnnealingLevel level = *annealing::level_on(triangulation, {.tether = default_tether});
  annealing::relax_level(level, annealing::TetherSurface(sphere(count), 1));
  return level;
}

// Rings by their number of atoms.
std::size_t rings_of(const AnnealedStart& start, std::size_t size) {
  const auto counts = annealing::ring_counts(start.level.state.network);
  return size < counts.size() ? counts[size] : 0;
}

TEST(RefinedStart, HasFourTimesTheAtomsAndTheDefectsOfTheCoarseOne) {
  ThreadTeam team(2);
  const auto start = refined_start(level_of(test::unit_sphere(4), atoms / 4), 1, sphere(atoms), atoms,
                                   std::numeric_limits<double>::infinity(), {.running = {&team}});
  ASSERT_TRUE(start.has_value());
  EXPECT_EQ(start->refinements, 1);
  EXPECT_EQ(start->level.state.positions.size(), atoms);
  EXPECT_EQ(rings_of(*start, 5), 12u);
  EXPECT_EQ(rings_of(*start, 7), 0u);
  EXPECT_TRUE(annealing::holds(start->level));
  EXPECT_LT(start->released.mean_distance, 1);
}

TEST(RefinedStart, IsNoneWhereTheWholeSizeHasLessEnergyWithoutAnnealing) {
  const double best = level_of(test::unit_sphere(8), atoms).unannealed;
  EXPECT_FALSE(
      refined_start(level_of(test::rough_sphere(4, 1, 0.2), atoms / 4), 1, sphere(atoms), atoms, best, {}));
}

TEST(AnnealedAtFullSize, LeavesARoughSphereItsTwelvePentagons) {
  ThreadTeam team(2);
  const annealing::AnnealingLevel rough = level_of(test::rough_sphere(4, 1, 0.2), 320);
  const AnnealedStart start = annealed_at_full_size(rough, sphere(320), 320, true, {.running = {&team}});
  EXPECT_EQ(start.refinements, 0);
  EXPECT_EQ(rings_of(start, 5), 12u);
  EXPECT_EQ(rings_of(start, 7), 0u);
  EXPECT_GT(start.level.accepted, 0u);
  EXPECT_LT(start.released.energy, rough.unannealed);
}

// A quarter of the atoms finds the twelve pentagons of a sphere; a rough start at full size keeps pairs of
// defects, and one without any cannot be beaten.
TEST(BestStart, IsTheRefinedOneOrTheOneAtFullSize) {
  ThreadTeam team(2);
  for (const bool rough : {true, false}) {
    const TriangleMesh triangulation = rough ? test::rough_sphere(8, 1, 0.2) : test::unit_sphere(8);
    const BestStart best =
        best_start(level_of(triangulation, atoms), sphere(atoms), atoms, {.running = {&team}});
    EXPECT_EQ(best.start.refinements, rough ? 1 : 0);
    EXPECT_EQ(rings_of(best.start, 5), 12u);
    EXPECT_EQ(rings_of(best.start, 7), 0u);
    EXPECT_GT(best.seconds, 0);
  }
}

}  // namespace
}  // namespace nanocarbon::building
