// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/refine_network.h"

#include <gtest/gtest.h>

#include "support/rough_sphere.h"

namespace nanocarbon::annealing {
namespace {

TEST(RefinedInFour, QuadruplesTheAtomsAndAddsNoDefects) {
  const TriangleMesh sphere = test::unit_sphere(4);
  SwitchingState coarse;
  coarse.network = trivalent_network(sphere);
  for (const Triangle& t : sphere.triangles)
    coarse.positions.push_back(5 * (sphere.points[t[0]] + sphere.points[t[1]] + sphere.points[t[2]]) / 3);
  const TetherSurface surface(test::unit_sphere(12), 10);
  const SwitchingState fine = refined_in_four(coarse, surface);
  EXPECT_EQ(fine.network.atoms.size(), 4u * 320u);
  EXPECT_EQ(fine.positions.size(), 4u * 320u);
  const auto counts = ring_counts(fine.network);
  ASSERT_EQ(counts.size(), 7u);
  EXPECT_EQ(counts[5], 12u);
  EXPECT_EQ(counts[6], 2u * 320u + 2 - 12);
  for (const Vec3& p : fine.positions) EXPECT_LT(surface.distance(p), 0.5);
}

}  // namespace
}  // namespace nanocarbon::annealing
