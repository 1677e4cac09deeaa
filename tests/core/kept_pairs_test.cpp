// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/kept_pairs.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "nanocarbon/core/neighbours_within.h"

namespace nanocarbon {
namespace {

constexpr double reach = 2.9, margin = 0.8;

bool all(std::uint32_t, std::uint32_t) { return true; }

// Two square grids of points, one above the other.
std::vector<Vec3> two_sheets(int side, double apart) {
  std::vector<Vec3> points;
  for (const double height : {0.0, apart})
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j) points.emplace_back(2.0 * i, 2.0 * j, height);
  return points;
}

// Whether every pair within reach is listed, in both rows, and no pair beyond what was looked for at the start.
void expect_complete(const KeptPairs& pairs, const std::vector<Vec3>& positions) {
  std::vector<std::size_t> offsets;
  std::vector<std::uint32_t> near;
  pairs.rows(offsets, near);
  const NeighbourList wanted = neighbours_within(positions, nullptr, reach);
  for (std::size_t a = 0; a < positions.size(); ++a)
    for (const Neighbour& n : wanted.of(a))
      EXPECT_TRUE(std::binary_search(near.begin() + static_cast<std::ptrdiff_t>(offsets[a]),
                                     near.begin() + static_cast<std::ptrdiff_t>(offsets[a + 1]), n.atom))
          << a << " and " << n.atom;
}

TEST(KeptPairs, AreThoseOfACellListAtFirst) {
  const std::vector<Vec3> positions = two_sheets(20, 3.0);
  KeptPairs pairs(reach, margin);
  EXPECT_TRUE(pairs.update(positions, all));
  std::vector<std::size_t> offsets;
  std::vector<std::uint32_t> near;
  pairs.rows(offsets, near);
  const NeighbourList wanted = neighbours_within(positions, nullptr, reach + margin);
  ASSERT_EQ(near.size(), wanted.neighbours.size());
  for (std::size_t k = 0; k < near.size(); ++k) EXPECT_EQ(near[k], wanted.neighbours[k].atom);
}

TEST(KeptPairs, NothingIsListedAnewWhereAllMovesAsAWhole) {
  std::vector<Vec3> positions = two_sheets(20, 3.0);
  KeptPairs pairs(reach, margin);
  pairs.update(positions, all);
  const Mat3 turn = Eigen::AngleAxisd(0.005, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (int step = 0; step < 5; ++step) {
    for (Vec3& p : positions) p = turn * p + Vec3(3, -1, 2);
    EXPECT_FALSE(pairs.update(positions, all));
  }
}

TEST(KeptPairs, OnlyWantedPairsAreListed) {
  const std::vector<Vec3> positions = two_sheets(8, 3.0);
  KeptPairs pairs(reach, margin);
  pairs.update(positions, [](std::uint32_t a, std::uint32_t b) { return (a < 64) != (b < 64); });
  std::vector<std::size_t> offsets;
  std::vector<std::uint32_t> near;
  pairs.rows(offsets, near);
  for (std::size_t a = 0; a < positions.size(); ++a) {
    EXPECT_GT(offsets[a + 1], offsets[a]);
    for (std::size_t k = offsets[a]; k < offsets[a + 1]; ++k) EXPECT_NE(near[k] < 64, a < 64);
  }
}

// One sheet slides over the other, turns, ripples, and comes down on it.
TEST(KeptPairs, NeverMissAnApproach) {
  constexpr int side = 24;
  std::vector<Vec3> positions = two_sheets(side, 6.0);
  KeptPairs pairs(reach, margin);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-1, 1);
  ThreadTeam team(2);
  for (int step = 0; step < 60; ++step) {
    const double size = step % 5 == 0 ? 0.5 : 0.05;
    const Mat3 turn =
        Eigen::AngleAxisd(0.1 * shift(random), Vec3(shift(random), shift(random), 1).normalized())
            .toRotationMatrix();
    const Vec3 move(shift(random), shift(random), shift(random));
    for (std::size_t a = 0; a < positions.size(); ++a) {
      if (a >= positions.size() / 2)
        positions[a] += Vec3(0.3, 0.1, -0.1 + 0.2 * std::sin(0.1 * positions[a].x()));
      positions[a] = turn * positions[a] + move + size * Vec3(shift(random), shift(random), shift(random));
    }
    pairs.update(positions, all, step % 2 ? &team : nullptr);
    expect_complete(pairs, positions);
  }
}

// A single atom crosses the whole structure in long steps.
TEST(KeptPairs, FindsWhatComesFromFarAway) {
  std::vector<Vec3> positions = two_sheets(24, 3.0);
  positions.emplace_back(-40, 20, 1.5);
  KeptPairs pairs(reach, margin);
  for (int step = 0; step < 60; ++step) {
    pairs.update(positions, all);
    expect_complete(pairs, positions);
    positions.back().x() += 2.7;
  }
}

}  // namespace
}  // namespace nanocarbon
