// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/lj/compact_order.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace nanocarbon::airebo {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

void expect_permutation(std::vector<std::uint32_t> order, std::size_t count) {
  ASSERT_EQ(order.size(), count);
  std::sort(order.begin(), order.end());
  for (std::uint32_t n = 0; n < count; ++n) EXPECT_EQ(order[n], n);
}

TEST(CompactOrder, HasEachPointOnce) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (std::size_t count = 0; count < 70; ++count) {
    std::vector<Vec3> points;
    for (std::size_t n = 0; n < count; ++n)
      points.emplace_back(normal(random), normal(random), normal(random));
    if (count > 9) points[9] = points[3];
    for (const std::size_t run : {1, 3, 4}) expect_permutation(compact_order(points, run), count);
  }
  EXPECT_THAT(compact_order({}, 4), IsEmpty());
}

TEST(CompactOrder, TakesEqualPointsAndThoseThatAreNotFinite) {
  expect_permutation(compact_order(std::vector<Vec3>(41, Vec3(1.0, 2.0, 3.0)), 4), 41);
  const std::vector<Vec3> points = {{NAN, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, -INFINITY, 0.0}, {1.0, 0.0, 0.0}};
  EXPECT_THAT(compact_order(points, 1), ElementsAre(3, 1, 0, 2));
}

// Two by two of a square lattice, and two by two by one or so of a cubic one, in whatever order its points come.
TEST(CompactOrder, RunsAreRound) {
  std::mt19937_64 random(2);
  for (const int layers : {1, 16}) {
    std::vector<Vec3> points;
    for (int x = 0; x < 16; ++x)
      for (int y = 0; y < 16; ++y)
        for (int z = 0; z < layers; ++z) points.emplace_back(x, y, z);
    std::shuffle(points.begin(), points.end(), random);
    const auto order = compact_order(points, 4);
    for (std::size_t begin = 0; begin < order.size(); begin += 4) {
      Vec3 low = points[order[begin]], high = low;
      for (std::size_t n = begin; n < begin + 4; ++n) {
        low = low.cwiseMin(points[order[n]]);
        high = high.cwiseMax(points[order[n]]);
      }
      EXPECT_LE((high - low).maxCoeff(), 1.0);
    }
  }
}

}  // namespace
}  // namespace nanocarbon::airebo
