// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/annealing_level.h"

#include <gtest/gtest.h>

#include "support/rough_sphere.h"

namespace nanocarbon::annealing {
namespace {

constexpr double radius = 12.25;  // Angstrom, of a sphere with room for 720 atoms

TriangleMesh sphere(int n) {
  TriangleMesh mesh = test::unit_sphere(n);
  for (Vec3& p : mesh.points) p *= radius;
  return mesh;
}

TEST(AnnealingLevel, AnIcosahedralFullereneHoldsAndLosesNothingOfItsSphere) {
  auto level = level_on(sphere(6), {.tether = 0.05});
  ASSERT_TRUE(level.has_value());
  relax_level(*level, TetherSurface(sphere(20), 1));
  EXPECT_TRUE(level->sound);
  EXPECT_TRUE(holds(*level));
  EXPECT_LT(lost_reach(*level, sphere(20)), 1.0);
}

TEST(AnnealingLevel, WhatTheSurfaceReachesBeyondTheMoleculeIsLost) {
  const auto level = level_on(sphere(6), {.tether = 0.05});
  TriangleMesh horned = sphere(20);
  Vec3& tip = horned.points[100];
  tip *= (radius + 9) / radius;
  EXPECT_NEAR(lost_reach(*level, horned), 9, 1.0);
}

// An atom pulled out by a tenth of the radius, 1.2 Angstrom: its bonds are longer than REBO2 sees whole.
TEST(AnnealingLevel, AnOverstretchedBondDoesNotHold) {
  auto level = level_on(sphere(6), {.tether = 0.05});
  relax_level(*level, TetherSurface(sphere(20), 1));
  level->state.positions[0] *= 1.1;
  EXPECT_FALSE(holds(*level));
}

TEST(AnnealingLevel, APinchedTriangulationIsNone) {
  TriangleMesh pinched = sphere(3);
  const Triangle first = pinched.triangles.front(), last = pinched.triangles.back();
  pinched.triangles.push_back({first[0], first[1], last[0]});  // a third one at an edge
  EXPECT_FALSE(level_on(pinched, {.tether = 0.05}).has_value());
}

}  // namespace
}  // namespace nanocarbon::annealing
