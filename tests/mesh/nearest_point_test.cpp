// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/nearest_point.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>
#include <thread>

#include "nanocarbon/mesh/triangulate.h"
#include "support/small_meshes.h"

namespace nanocarbon::mesh {
namespace {

std::vector<Vec3> random_points(std::size_t n, double extent, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-extent, extent);
  std::vector<Vec3> points(n);
  for (Vec3& p : points) p = Vec3(uniform(random), uniform(random), uniform(random));
  return points;
}

double distance_by_trying_all(const TriangleMesh& mesh, const Vec3& query) {
  double best = 1e300;
  for (const auto& [a, b, c] : mesh.triangles)
    best = std::min(
        best, (nearest_on_triangle(query, mesh.points[a], mesh.points[b], mesh.points[c]) - query).norm());
  return best;
}

TEST(NearestOnTriangle, InEveryRegion) {
  const Vec3 a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
  const auto near = [&](const Vec3& p) { return nearest_on_triangle(p, a, b, c); };
  EXPECT_TRUE(near(Vec3(1, 1, 7)).isApprox(Vec3(1, 1, 0)));
  EXPECT_EQ(near(Vec3(-1, -2, 3)), a);
  EXPECT_EQ(near(Vec3(7, -1, 1)), b);
  EXPECT_EQ(near(Vec3(-1, 9, -1)), c);
  EXPECT_TRUE(near(Vec3(1, -3, 2)).isApprox(Vec3(1, 0, 0)));
  EXPECT_TRUE(near(Vec3(-5, 2, 2)).isApprox(Vec3(0, 2, 0)));
  EXPECT_TRUE(near(Vec3(4, 4, 2)).isApprox(Vec3(2, 2, 0)));
}

TEST(NearestOnTriangle, WithoutAreaItIsTheSegmentOrThePoint) {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(3, 0, 0);
  for (const auto& [p, q, r] :
       {std::array{a, b, c}, {b, c, a}, {c, a, b}, {a, c, b}, {c, b, a}, {a, a, c}, {a, c, c}}) {
    EXPECT_TRUE(nearest_on_triangle(Vec3(2, 1, 0), p, q, r).isApprox(Vec3(2, 0, 0)));
    EXPECT_EQ(nearest_on_triangle(Vec3(-2, 1, 0), p, q, r), a);
    EXPECT_EQ(nearest_on_triangle(Vec3(5, 1, 0), p, q, r), c);
  }
  EXPECT_EQ(nearest_on_triangle(Vec3(5, 1, 0), b, b, b), b);
}

// Nothing on the triangle is nearer than what was found, and what was found is on the triangle.
TEST(NearestOnTriangle, NoPointOfTheTriangleIsNearer) {
  const auto points = random_points(4000, 1.0, 5);
  for (std::size_t i = 0; i + 3 < points.size(); i += 4) {
    const Vec3 &p = points[i], &a = points[i + 1], &b = points[i + 2], &c = points[i + 3];
    const double found = (nearest_on_triangle(p, a, b, c) - p).norm();
    double best = 1e300;
    for (int u = 0; u <= 40; ++u)
      for (int v = 0; u + v <= 40; ++v) {
        const Vec3 on = a + u / 40.0 * (b - a) + v / 40.0 * (c - a);
        best = std::min(best, (on - p).norm());
      }
    EXPECT_LE(found, best + 1e-12);
    EXPECT_GE(found, best - 0.1);  // the grid's spacing
  }
}

TEST(NearestPoint, IsTheOneThatTryingAllTrianglesFinds) {
  const TriangleMesh mesh = triangulate(test::torus(40, 20)).mesh;
  const NearestPoint nearest(mesh);
  for (const double extent : {0.5, 3.0, 6.0, 1000.0})
    for (const Vec3& query : random_points(300, extent, 7)) {
      const SurfacePoint found = nearest.nearest(query);
      EXPECT_DOUBLE_EQ(found.distance, distance_by_trying_all(mesh, query));
      EXPECT_DOUBLE_EQ((found.point - query).norm(), found.distance);
      const auto& [a, b, c] = mesh.triangles[found.triangle];
      EXPECT_EQ(nearest_on_triangle(query, mesh.points[a], mesh.points[b], mesh.points[c]), found.point);
    }
}

TEST(NearestPoint, AHintChangesNothingButTheTime) {
  const TriangleMesh mesh = triangulate(test::torus(40, 20)).mesh;
  const NearestPoint nearest(mesh);
  std::uint32_t hint = 0;
  const auto queries = random_points(500, 4.0, 8);
  const auto batch = nearest.nearest(queries);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const double expected = nearest.nearest(queries[i]).distance;
    EXPECT_EQ(nearest.nearest(queries[i], hint).distance, expected);
    EXPECT_EQ(batch[i].distance, expected);
    hint = (hint + 37) % static_cast<std::uint32_t>(mesh.triangles.size());
  }
}

TEST(NearestPoint, PointsOfTheSurfaceAreAtDistanceZero) {
  const TriangleMesh mesh = triangulate(test::torus(40, 20)).mesh;
  const NearestPoint nearest(mesh);
  for (const Vec3& point : mesh.points) EXPECT_EQ(nearest.nearest(point).distance, 0.0);
}

TEST(NearestPoint, OneTriangleAndManyAtOnePlace) {
  TriangleMesh mesh{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{0, 1, 2}}};
  EXPECT_DOUBLE_EQ(NearestPoint(mesh).nearest(Vec3(0.2, 0.2, 3)).distance, 3.0);
  mesh.triangles.resize(1000, {0, 1, 2});
  EXPECT_DOUBLE_EQ(NearestPoint(mesh).nearest(Vec3(0.2, 0.2, 3)).distance, 3.0);
}

// Centres that shrink towards a corner make the most lopsided tree there is.
TEST(NearestPoint, SizesOverManyOrdersOfMagnitude) {
  TriangleMesh mesh;
  for (VertexIndex t = 0; t < 900; ++t) {
    const double x = std::pow(0.5, t);
    mesh.points.insert(mesh.points.end(), {Vec3(x, 0, 0), Vec3(x, 0.1 * x, 0), Vec3(x, 0, 0.1 * x)});
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  const NearestPoint nearest(mesh);
  for (const Vec3& query : random_points(100, 1.0, 9))
    EXPECT_DOUBLE_EQ(nearest.nearest(query).distance, distance_by_trying_all(mesh, query));
}

TEST(NearestPoint, QueriesOfSeveralThreadsAgree) {
  const NearestPoint nearest(triangulate(test::torus(40, 20)).mesh);
  const auto queries = random_points(2000, 5.0, 10);
  std::vector<double> here, there;
  std::thread other([&] {
    for (const Vec3& query : queries) there.push_back(nearest.nearest(query).distance);
  });
  for (const Vec3& query : queries) here.push_back(nearest.nearest(query).distance);
  other.join();
  EXPECT_EQ(here, there);
}

}  // namespace
}  // namespace nanocarbon::mesh
