// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/crystal_start.h"

#include <gtest/gtest.h>

#include "nanocarbon/shapes/shapes.h"
#include "support/refusal.h"
#include "support/rough_sphere.h"

namespace nanocarbon::building {
namespace {

TriangleMesh sphere_for(std::size_t atoms) {
  TriangleMesh surface = test::unit_sphere(16);
  rescale(surface, test::scale_for(atoms, 4 * std::numbers::pi));
  return surface;
}

TEST(CrystalStart, HasTheAtomsAskedForOnTheSurface) {
  const TriangleMesh surface = sphere_for(500);
  const CrystalStart start = crystal_start(surface, 500, {.tether = 0.07, .keep_size = true});
  ASSERT_TRUE(start.level.has_value());
  EXPECT_NEAR(static_cast<double>(start.level->state.positions.size()), 500, 5);
  for (const Vec3& p : start.level->state.positions) EXPECT_NEAR(p.norm(), surface.points[0].norm(), 0.3);
  EXPECT_EQ(start.level->state.tether, 0.07);
  EXPECT_FALSE(start.level->state.free_mean);
  EXPECT_GT(start.seconds, 0);
}

TEST(CrystalStart, FollowsTheSeed) {
  const TriangleMesh surface = sphere_for(300);
  const auto positions = [&](std::uint64_t seed) {
    return crystal_start(surface, 300, {.seed = seed}).level->state.positions;
  };
  EXPECT_EQ(positions(1), positions(1));
  EXPECT_NE(positions(1), positions(2));
}

// Fourteen triangles are the least that a torus can have.
TEST(CrystalStart, TooFewAtomsForTheTopologyAreRefused) {
  const TriangleMesh torus = shapes::make_torus(3, 1, 0.3);
  test::refusal(Failure::size, [&] { crystal_start(torus, 10, {}); });
  test::refusal(Failure::size, [&] { full_size_start(torus, 10, {}); });
}

}  // namespace
}  // namespace nanocarbon::building
