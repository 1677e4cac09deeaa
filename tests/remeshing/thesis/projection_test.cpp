// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/projection.h"

#include <gmock/gmock.h>

#include <random>

#include "nanocarbon/mesh/nearest_point.h"
#include "remeshing/shapes.h"

namespace nanocarbon::thesis {
namespace {

std::vector<Vec3> points_near_torus(std::size_t count, double off) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> angle(0.0, 2 * M_PI), away(1.0 - off, 1.0 + off);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double a = angle(random), b = angle(random), minor = away(random), r = 3.0 + minor * std::cos(b);
    points.emplace_back(r * std::cos(a), r * std::sin(a), minor * std::sin(b));
  }
  return points;
}

TEST(Projection, EndsOnTheSurfaceNoNearerThanTheNearestPoint) {
  // An uneven sheet, sheared so that many triangles are obtuse: the nearest vertex is often not one of the
  // nearest triangle.
  TriangleMesh sheet = test::sheet(20.0, 20.0, 20, 20);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> jitter(-0.3, 0.3), inside(3.0, 17.0);
  for (Vec3& p : sheet.points)
    p = Vec3(p.x() + jitter(random), p.y() + jitter(random) - 1.5 * p.x(), 0.2 * jitter(random));
  const ProjectionMesh projection(sheet);
  const mesh::NearestPoint exact(sheet);
  std::size_t missed_with_one = 0, missed_with_five = 0;
  for (int i = 0; i < 2000; ++i) {
    const double x = inside(random);
    const Vec3 p(x, inside(random) - 1.5 * x, jitter(random));
    const double least = exact.nearest(p).distance;
    for (const unsigned nearest : {1u, 5u}) {
      const Vec3 projected = projection.project(p, nearest);
      EXPECT_NEAR(exact.nearest(projected).distance, 0.0, 1e-12);
      const double distance = (projected - p).norm();
      EXPECT_GE(distance, least - 1e-12);
      (nearest == 1 ? missed_with_one : missed_with_five) += distance > least + 1e-9;
    }
  }
  // What the thesis added the four further vertices for.
  EXPECT_GT(missed_with_one, 0u);
  EXPECT_LT(missed_with_five, missed_with_one);
}

TEST(Projection, PointsOfTheSurfaceStay) {
  const TriangleMesh sphere = test::sphere(2.0, 3);
  std::vector<Vec3> points = sphere.points;
  for (const auto& [a, b, c] : sphere.triangles)
    points.push_back((sphere.points[a] + sphere.points[b] + sphere.points[c]) / 3.0);
  const std::vector<Vec3> before = points;
  const ProjectionTotals totals = project_points(points, ProjectionMesh(sphere), 5);
  EXPECT_NEAR(totals.max_move, 0.0, 1e-12);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_TRUE(points[i].isApprox(before[i], 1e-12));
}

TEST(Projection, TellsHowFarPointsMoved) {
  std::vector<Vec3> points = {{0.4, 0.5, 3.0}, {0.6, 0.5, -1.0}};
  const ProjectionTotals totals = project_points(points, ProjectionMesh(test::sheet(1.0, 1.0, 4, 4)), 5);
  EXPECT_DOUBLE_EQ(totals.max_move, 3.0);
  EXPECT_DOUBLE_EQ(totals.mean_move, 2.0);
  EXPECT_TRUE(points[0].isApprox(Vec3(0.4, 0.5, 0.0)));
}

// A mesh too small for five vertices, one with needles and one with a triangle without area.
TEST(Projection, WorksOnSmallAndDegenerateMeshes) {
  const TriangleMesh single{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_TRUE(ProjectionMesh(single).project({2, 2, 1}, 5).isApprox(Vec3(0.5, 0.5, 0.0)));
  const TriangleMesh degenerate{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 0}}, {{0, 1, 2}, {0, 3, 1}}};
  EXPECT_TRUE(ProjectionMesh(degenerate).project({1.5, 1.0, 0.0}, 5).isApprox(Vec3(1.5, 0, 0)));
}

// Parallel runs must not differ: many points, so that threads are used where there are any.
TEST(Projection, EveryRunGivesTheSameBits) {
  const ProjectionMesh projection(test::torus(3.0, 1.0, 40, 16));
  const std::vector<Vec3> start = points_near_torus(30000, 0.3);
  std::vector<Vec3> first = start;
  project_points(first, projection, 5);
  for (std::size_t i = 0; i < start.size(); ++i) ASSERT_EQ(first[i], projection.project(start[i], 5));
}

}  // namespace
}  // namespace nanocarbon::thesis
