// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/space.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

namespace nanocarbon {
namespace {

std::mt19937 generator(7);

Vec3 random_point(double size) {
  std::uniform_real_distribution<double> uniform(-size, size);
  return {uniform(generator), uniform(generator), uniform(generator)};
}

Cell cell_of(std::initializer_list<Vec3> edges, std::array<bool, 3> periodic = {true, true, true}) {
  Cell cell;
  int column = 0;
  for (const Vec3& edge : edges) cell.vectors.col(column++) = edge;
  cell.periodic = periodic;
  return cell;
}

// The cells of the three cubic lattices, a skewed one, and a slab.
std::vector<Cell> cells() {
  return {orthogonal_cell({10, 12, 9}), cell_of({Vec3(0, 8, 8), Vec3(8, 0, 8), Vec3(8, 8, 0)}),
          cell_of({Vec3(-7, 7, 7), Vec3(7, -7, 7), Vec3(7, 7, -7)}),
          cell_of({Vec3(11, 0, 0), Vec3(5.5, 9, 0), Vec3(-5.4, 4.4, 13)}),
          cell_of({Vec3(11, 0, 0), Vec3(5, 9, 0), Vec3(0, 0, 20)}, {true, true, false})};
}

TEST(Space, OfNoCellGivesThePlainDifferenceBitForBit) {
  const Space free;
  for (int k = 0; k < 1000; ++k) {
    const Vec3 a = random_point(1e3), b = random_point(1e-3);
    EXPECT_EQ(free.displacement(a, b), Vec3(b - a));
    EXPECT_EQ(free.beside(a, b), a);
  }
  EXPECT_FALSE(free.periodic());
  EXPECT_TRUE(std::isinf(free.least_width()));
}

TEST(Space, FindsTheNearestOfAllImages) {
  for (const Cell& cell : cells()) {
    const Space space(cell);
    for (int k = 0; k < 2000; ++k) {
      const Vec3 a = random_point(40), b = random_point(40);
      double nearest = 1e300;
      for (int i = -12; i <= 12; ++i)
        for (int j = -12; j <= 12; ++j)
          for (int l = -12; l <= 12; ++l) {
            if ((i && !cell.periodic[0]) || (j && !cell.periodic[1]) || (l && !cell.periodic[2])) continue;
            nearest = std::min(nearest, (b - a + image_shift(cell, {i, j, l})).norm());
          }
      EXPECT_NEAR(space.displacement(a, b).norm(), nearest, 1e-11);
    }
  }
}

TEST(Space, DisplacementsDoNotChangeWhenPointsAreMovedByTranslations) {
  for (const Cell& cell : cells()) {
    const Space space(cell);
    for (int k = 0; k < 200; ++k) {
      const Vec3 a = random_point(4), b = a + random_point(1.5);
      const Vec3 shift = image_shift(cell, {cell.periodic[0] ? 3 : 0, -2, cell.periodic[2] ? 5 : 0});
      EXPECT_LT((space.displacement(a + shift, b) - (b - a)).norm(), 1e-12);
      EXPECT_LT((space.beside(b + shift, a) - b).norm(), 1e-12);
    }
  }
}

TEST(Space, LeastWidthIsTheShortestTranslation) {
  EXPECT_DOUBLE_EQ(Space(orthogonal_cell({10, 12, 9})).least_width(), 9);
  EXPECT_DOUBLE_EQ(Space(cell_of({Vec3(0, 8, 8), Vec3(8, 0, 8), Vec3(8, 8, 0)})).least_width(),
                   8 * std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(Space(cell_of({Vec3(-7, 7, 7), Vec3(7, -7, 7), Vec3(7, 7, -7)})).least_width(),
                   7 * std::sqrt(3.0));
}

TEST(Space, WrapsPointsIntoTheCellByTranslations) {
  for (const Cell& cell : cells()) {
    const Space space(cell);
    for (int k = 0; k < 200; ++k) {
      const Vec3 p = random_point(50), inside = space.wrapped(p);
      const Vec3 fractional = cell.vectors.inverse() * inside, moved = cell.vectors.inverse() * (inside - p);
      for (int d = 0; d < 3; ++d) {
        EXPECT_NEAR(moved[d], std::round(moved[d]), 1e-10);
        if (!cell.periodic[static_cast<std::size_t>(d)]) continue;
        EXPECT_GE(fractional[d], -1e-12);
        EXPECT_LT(fractional[d], 1 + 1e-12);
      }
    }
  }
  EXPECT_EQ(Space().wrapped(Vec3(1, -2, 3)), Vec3(1, -2, 3));
}

TEST(Space, ImagesLeadToTheNearestPlace) {
  for (const Cell& cell : cells()) {
    const Space space(cell);
    for (int k = 0; k < 200; ++k) {
      const Vec3 a = random_point(40), b = random_point(40);
      EXPECT_LT((b + image_shift(cell, space.image(a, b)) - a - space.displacement(a, b)).norm(), 1e-11);
    }
  }
  EXPECT_EQ(Space().image(Vec3(1, 2, 3), Vec3(40, 5, 6)), (std::array<std::int32_t, 3>{0, 0, 0}));
}

TEST(Space, StrainsItsCell) {
  Mat3 deformation = Mat3::Identity();
  deformation(0, 0) = 1.1;
  const Space space = Space(orthogonal_cell({10, 12, 9})).strained(deformation);
  EXPECT_NEAR(space.displacement(Vec3::Zero(), Vec3(10.9, 0, 0)).x(), -0.1, 1e-12);
}

TEST(Space, ScalesWithItsCell) {
  const Space space = Space(orthogonal_cell({10, 12, 9})).scaled(0.5);
  EXPECT_DOUBLE_EQ(space.least_width(), 4.5);
  EXPECT_EQ(space.displacement(Vec3(0, 0, 0), Vec3(4, 0, 0)), Vec3(-1, 0, 0));
  EXPECT_FALSE(Space().scaled(2).periodic());
}

}  // namespace
}  // namespace nanocarbon
