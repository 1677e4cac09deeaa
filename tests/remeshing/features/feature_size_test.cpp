// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/features/feature_size.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "nanocarbon/mesh/measures.h"
#include "remeshing/shapes.h"

namespace nanocarbon::features {
namespace {

FeatureReport check(const TriangleMesh& surface) { return check_features(surface); }

//! A box of 12 triangles with a corner at the origin.
TriangleMesh box(const Vec3& size) {
  TriangleMesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.points.push_back(size.cwiseProduct(Vec3(k & 1, (k >> 1) & 1, (k >> 2) & 1)));
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TriangleMesh joined(TriangleMesh one, const TriangleMesh& other) {
  const auto shift = static_cast<VertexIndex>(one.points.size());
  one.points.insert(one.points.end(), other.points.begin(), other.points.end());
  for (const Triangle& t : other.triangles)
    one.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return one;
}

TEST(FeatureSize, WideShapesHaveNoProblem) {
  EXPECT_TRUE(check(test::sphere(12, 4)).ok());
  EXPECT_TRUE(check(test::torus(30, 6, 100, 40)).ok());
}

TEST(FeatureSize, SharpEdgesAreNoThinParts) {
  EXPECT_TRUE(check(box(Vec3(20, 25, 30))).ok());
  EXPECT_TRUE(check(test::icosahedron(15)).ok());
}

TEST(FeatureSize, RoughnessIsNoThinPart) {
  TriangleMesh rough = test::sphere(20, 5);
  std::mt19937 random(1);
  for (Vec3& p : rough.points) p *= 1 + 0.01 * (static_cast<double>(random() % 1000) / 500 - 1);
  EXPECT_TRUE(check(rough).ok());
}

TEST(FeatureSize, AThinTorusIsAThinPartOfItsRadius) {
  const TriangleMesh surface = test::torus(20, 1.5, 160, 20);
  const FeatureReport report = check(surface);
  ASSERT_EQ(report.problems.size(), 1u);
  const FeatureProblem& problem = report.problems.front();
  EXPECT_EQ(problem.kind, FeatureKind::thin_part);
  // Sides up to 32 degrees off from opposite count: chords shorter than the diameter by 4%, of a 20-gon on
  // top.
  EXPECT_NEAR(problem.size, 1.5, 0.08 * 1.5);
  EXPECT_NEAR(std::hypot(problem.where.x(), problem.where.y()), 20, 1.6);
  EXPECT_NEAR(problem.area, mesh::area(surface), 0.02 * mesh::area(surface));
}

TEST(FeatureSize, TwoSidesCloserThanGraphiteAreAThinPlate) {
  const FeatureReport report = check(box(Vec3(40, 40, 2)));
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.problems.front().kind, FeatureKind::thin_wall);
  EXPECT_NEAR(report.problems.front().size, 2, 0.05);
  EXPECT_TRUE(check(box(Vec3(40, 40, 4))).ok());
}

TEST(FeatureSize, NeighbouringBodiesLeaveANarrowGap) {
  TriangleMesh upper = box(Vec3(30, 30, 20));
  for (Vec3& p : upper.points) p.z() += 22;
  const FeatureReport report = check(joined(box(Vec3(30, 30, 20)), upper));
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.problems.front().kind, FeatureKind::narrow_gap);
  EXPECT_NEAR(report.problems.front().size, 2, 0.05);
  EXPECT_GT(report.problems.front().where.z(), 19.9);
  EXPECT_LT(report.problems.front().where.z(), 22.1);
}

TEST(FeatureSize, ShellsWithinEachOtherLeaveANarrowGap) {
  EXPECT_TRUE(check(joined(test::sphere(10, 4), test::sphere(13.5, 4))).ok());
  const FeatureReport report = check(joined(test::sphere(10, 4), test::sphere(12, 4)));
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.problems.front().kind, FeatureKind::narrow_gap);
}

//! A flat sheet with a round hole in the middle.
TriangleMesh annulus(double inner, double outer) {
  return test::grid(60, 40, {true, false}, [&](double u, double v) {
    const double a = 2 * std::numbers::pi * u, r = outer + (inner - outer) * v;
    return Vec3(r * std::cos(a), r * std::sin(a), 0.0);
  });
}

TEST(FeatureSize, AHoleThatCarbonWouldCloseIsFound) {
  const FeatureReport report = check(annulus(1.7, 50));
  ASSERT_EQ(report.problems.size(), 1u);
  EXPECT_EQ(report.problems.front().kind, FeatureKind::small_hole);
  EXPECT_NEAR(report.problems.front().size, 1.7, 0.02);
  EXPECT_LT(report.problems.front().where.norm(), 1e-9);
  EXPECT_NEAR(report.enlargement, FeatureLimits().hole_radius / 1.7, 0.02);
  EXPECT_TRUE(check(annulus(6, 50)).ok());
}

TEST(FeatureSize, TheEndOfATubeAndTheOutlineOfASheetAreNoHoles) {
  EXPECT_TRUE(check(test::open_tube(2.5, 30, 24, 60)).ok());
  EXPECT_TRUE(check(test::sheet(4, 4, 4, 4)).ok());
}

// What is said to be enough is, as long as nothing but the size changes.
TEST(FeatureSize, TheEnlargementIsEnough) {
  for (const TriangleMesh& surface : {test::torus(20, 1.5, 160, 20), box(Vec3(40, 40, 2))}) {
    const FeatureReport report = check(surface);
    ASSERT_FALSE(report.ok());
    TriangleMesh larger = surface;
    for (Vec3& p : larger.points) p *= 1.02 * report.enlargement;
    EXPECT_TRUE(check(larger).ok());
  }
}

}  // namespace
}  // namespace nanocarbon::features
