// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/gaussian_curvature_kept.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "remeshing/shapes.h"

namespace nanocarbon::building {
namespace {

constexpr double pi = std::numbers::pi;

//! A tube of radius 6 whose axis is part of a circle; always as long.
TriangleMesh bent_tube(double radius, int around, int along) {
  return test::grid(around, along, {true, false}, [=](double u, double v) {
    const double round = 2 * pi * u, at = 23 * pi / radius * (v - 0.5), out = radius - 6 * std::cos(round);
    return Vec3(out * std::cos(at), out * std::sin(at), 6 * std::sin(round));
  });
}

TriangleMesh bowl(double radius, double depth, int fineness) {
  return test::grid(fineness, fineness, {false, false}, [=](double u, double v) {
    const double x = radius * (2 * u - 1), y = radius * (2 * v - 1);
    return Vec3(x, y, depth * (x * x + y * y) / (radius * radius));
  });
}

TEST(GaussianCurvatureKept, IsAllWhereTheFormIs) {
  EXPECT_NEAR(gaussian_curvature_kept(bowl(12, 8, 12), bowl(12, 8, 37)).value(), 1, 0.1);
  EXPECT_NEAR(gaussian_curvature_kept(bent_tube(23, 15, 29), bent_tube(23, 41, 80)).value(), 1, 0.1);
}

// Both the dome of its outer and the saddle of its inner side go as the angle does that it spans.
TEST(GaussianCurvatureKept, IsLessWhereATubeHasUnbent) {
  for (const double radius : {26.0, 30.0}) {
    TriangleMesh opened = bent_tube(radius, 15, 29);
    for (Vec3& p : opened.points) p += Vec3(23 - radius, 0, 0);
    EXPECT_NEAR(gaussian_curvature_kept(opened, bent_tube(23, 41, 80)).value(), 23 / radius, 0.1) << radius;
  }
}

TEST(GaussianCurvatureKept, IsNoneWhereAMoleculeIsRolled) {
  const TriangleMesh rolled = test::grid(12, 12, {false, false}, [](double u, double v) {
    return Vec3(24 * u - 12, 24 * v - 12, 8 * (2 * u - 1) * (2 * u - 1));
  });
  EXPECT_NEAR(gaussian_curvature_kept(rolled, bowl(12, 8, 37)).value(), 0, 1e-3);
}

TEST(GaussianCurvatureKept, MeansNothingForSurfacesThatCanBeRolled) {
  EXPECT_FALSE(gaussian_curvature_kept(bowl(12, 0, 12), bowl(12, 0, 37)));
  EXPECT_FALSE(gaussian_curvature_kept(test::open_tube(6, 30, 16, 14), test::open_tube(6, 30, 30, 30)));
  EXPECT_FALSE(gaussian_curvature_kept(bowl(12, 0, 12), bowl(12, 1, 37)));
}

}  // namespace
}  // namespace nanocarbon::building
