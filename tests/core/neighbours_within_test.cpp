// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/neighbours_within.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace nanocarbon {
namespace {

std::vector<Vec3> random_points(std::size_t n, double extent, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-extent, extent);
  std::vector<Vec3> points(n);
  for (Vec3& p : points) p = Vec3(uniform(random), uniform(random), uniform(random));
  return points;
}

NeighbourList by_brute_force(const std::vector<Vec3>& points, const Cell* cell, double cutoff, int images) {
  NeighbourList list{{0}, {}};
  const auto range = [&](int d) { return cell && cell->periodic[d] ? images : 0; };
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::uint32_t j = 0; j < points.size(); ++j)
      for (int a = -range(0); a <= range(0); ++a)
        for (int b = -range(1); b <= range(1); ++b)
          for (int c = -range(2); c <= range(2); ++c) {
            if (i == j && a == 0 && b == 0 && c == 0) continue;
            Vec3 delta = points[j] - points[i];
            if (cell) delta += image_shift(*cell, {a, b, c});
            if (delta.norm() < cutoff) list.neighbours.push_back({j, {a, b, c}});
          }
    list.offsets.push_back(list.neighbours.size());
  }
  return list;
}

void expect_same(const NeighbourList& list, const NeighbourList& expected) {
  EXPECT_EQ(list.offsets, expected.offsets);
  EXPECT_TRUE(list.neighbours == expected.neighbours);
}

TEST(NeighboursWithin, AgreesWithBruteForceInFreeSpace) {
  const auto points = random_points(300, 6.0, 1);
  expect_same(neighbours_within(points, nullptr, 2.0), by_brute_force(points, nullptr, 2.0, 0));
}

TEST(NeighboursWithin, AgreesWithBruteForceInTriclinicCellsAlsoSmallerThanTheCutoff) {
  for (const double size : {1.3, 3.0, 9.0}) {
    Cell cell;
    cell.vectors << 1.0, 0.3, -0.2, 0.0, 1.1, 0.4, 0.0, 0.0, 0.9;
    cell.vectors *= size;
    cell.origin = Vec3(-2.0, 0.5, 1.0);
    for (const std::array<bool, 3> periodic :
         {std::array{true, true, true}, {true, false, true}, {false, false, true}}) {
      cell.periodic = periodic;
      // Points also lie well outside the cell, as unwrapped trajectories have them.
      const auto points = random_points(40, 1.2 * size, 7);
      expect_same(neighbours_within(points, &cell, 2.0), by_brute_force(points, &cell, 2.0, 9));
    }
  }
}

TEST(NeighboursWithin, AnAtomIsItsOwnNeighbourThroughTheBoundary) {
  const Cell cell = orthogonal_cell(Vec3(1.5, 50, 50));
  const std::vector<Vec3> one = {Vec3(0, 0, 0)};
  const auto list = neighbours_within(one, &cell, 2.0);
  ASSERT_EQ(list.of(0).size(), 2u);
  EXPECT_EQ(list.of(0)[0].image, (std::array<std::int32_t, 3>{-1, 0, 0}));
}

TEST(NeighboursWithin, FarAwayAtomsCostNothing) {
  std::vector<Vec3> points = random_points(1000, 8.0, 3);
  points.push_back(Vec3(1e9, -1e9, 1e9));
  const auto list = neighbours_within(points, nullptr, 2.0);
  EXPECT_TRUE(list.of(1000).empty());
}

TEST(NeighboursWithin, NoAtomsGiveAnEmptyList) { EXPECT_EQ(neighbours_within({}, nullptr, 2.0).atoms(), 0u); }

}  // namespace
}  // namespace nanocarbon
