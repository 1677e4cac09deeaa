// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/length_interval.h"

#include <gmock/gmock.h>

#include <cmath>

#include "remeshing/shapes.h"

namespace nanocarbon::thesis {
namespace {

// The reason for sqrt(3): measured on a lattice, not taken from the formula.
TEST(LengthInterval, BondsOfAnEquilateralLatticeAreSqrt3ShorterThanItsEdges) {
  const TriangleMesh lattice = test::equilateral_sheet(1.0, 2, 2);
  const auto centre = [&](std::size_t t) {
    const auto [a, b, c] = lattice.triangles[t];
    return Vec3((lattice.points[a] + lattice.points[b] + lattice.points[c]) / 3.0);
  };
  const double bond = (centre(0) - centre(1)).norm();  // the two triangles of a cell share an edge
  const LengthInterval edges = edge_interval(0.9 * bond, 1.1 * bond);
  EXPECT_NEAR(edges.mean(), 1.0, 1e-12);
  EXPECT_NEAR(edges.min, 0.9, 1e-12);
}

TEST(LengthInterval, BothEndsBelongToIt) {
  const LengthInterval interval{1.0, 2.0};
  EXPECT_TRUE(interval.contains(1.0));
  EXPECT_TRUE(interval.contains(2.0));
  EXPECT_TRUE(interval.is_short(std::nextafter(1.0, 0.0)));
  EXPECT_TRUE(interval.is_long(std::nextafter(2.0, 3.0)));
}

// Section 4.1: min(2 m_i, m) -+ (l_max - l_min) / 2.
TEST(InterpolatedInterval, IsTheTargetForACoarseMesh) {
  const LengthInterval target{1.2, 1.8};
  for (const double mean : {0.75, 1.5, 20.0}) {
    EXPECT_DOUBLE_EQ(interpolated_interval(target, mean).min, 1.2);
    EXPECT_DOUBLE_EQ(interpolated_interval(target, mean).max, 1.8);
  }
}

TEST(InterpolatedInterval, IsAroundTwiceTheMeanForAFineMesh) {
  const LengthInterval fine = interpolated_interval({1.2, 1.8}, 0.5);
  EXPECT_DOUBLE_EQ(fine.min, 0.7);
  EXPECT_DOUBLE_EQ(fine.max, 1.3);
}

// However fine the mesh, an edge of mean length must not be beyond being collapsed, or nothing would ever
// happen.
TEST(InterpolatedInterval, LeavesSomethingToCollapseOnAVeryFineMesh) {
  for (const double mean : {0.3, 0.1, 1e-3, 1e-9})
    EXPECT_GE(interpolated_interval({1.2, 1.8}, mean).min, mean);
}

}  // namespace
}  // namespace nanocarbon::thesis
