// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/distance.h"

#include <gmock/gmock.h>

#include <cmath>

#include "nanocarbon/mesh/triangulate.h"
#include "support/small_meshes.h"

namespace nanocarbon::mesh {
namespace {

TEST(Distance, OfASurfaceToItselfIsZero) {
  const TriangleMesh mesh = triangulate(test::torus(20, 10)).mesh;
  const SurfaceDistance distance = distance_between(mesh, mesh);
  EXPECT_EQ(distance.there.max, 0.0);
  EXPECT_LT(distance.back.max, 1e-14);
}

TEST(Distance, BetweenParallelSquaresIsTheirSeparation) {
  TriangleMesh low{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}, {{0, 1, 2}, {0, 2, 3}}};
  TriangleMesh high = low;
  for (Vec3& p : high.points) p.z() = 0.25;
  const SurfaceDistance distance = distance_between(low, high, 100);
  for (const DistanceStatistics& way : {distance.there, distance.back}) {
    EXPECT_DOUBLE_EQ(way.mean, 0.25);
    EXPECT_DOUBLE_EQ(way.rms, 0.25);
    EXPECT_DOUBLE_EQ(way.max, 0.25);
  }
}

TEST(Distance, TheWayBackSeesWhatTheMeshDoesNotReach) {
  // A triangle that covers half of the square lies on it, yet the far corner is 1/sqrt(2) away.
  const TriangleMesh square{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)},
                            {{0, 1, 2}, {0, 2, 3}}};
  const TriangleMesh half{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0)}, {{0, 1, 2}}};
  const SurfaceDistance distance = distance_between(half, square, 20000);
  EXPECT_EQ(distance.there.max, 0.0);
  EXPECT_DOUBLE_EQ(distance.back.max, std::sqrt(0.5));
  EXPECT_EQ(distance.back.farthest, Vec3(0, 1, 0));
  EXPECT_DOUBLE_EQ(distance.hausdorff(), std::sqrt(0.5));
  // Half of the square is covered; over the other half the distance to the diagonal averages 1/3 of the
  // largest.
  EXPECT_NEAR(distance.back.mean, std::sqrt(0.5) / 6.0, 1e-3);
  EXPECT_NEAR(distance.back.rms, std::sqrt(0.5 / 12.0), 1e-3);  // mean square: half of h^2/6
}

TEST(Distance, OfPointsOnASphereAroundATetrahedronsCentre) {
  const NearestPoint surface(test::tetrahedron());
  // Towards a face's centre the inscribed sphere touches, radius 1/sqrt(3); towards a vertex, at sqrt(3).
  const std::vector<Vec3> points = {Vec3(-3, -3, -3), Vec3(3, 3, 3)};
  const DistanceStatistics statistics = distances_to_surface(points, surface);
  const double near = 3 * std::sqrt(3.0) - std::sqrt(3.0), far = 3 * std::sqrt(3.0) - 1 / std::sqrt(3.0);
  EXPECT_NEAR(statistics.max, far, 1e-14);
  EXPECT_EQ(statistics.farthest, points[0]);
  EXPECT_NEAR(statistics.mean, (near + far) / 2, 1e-14);
  EXPECT_NEAR(statistics.rms, std::sqrt((near * near + far * far) / 2), 1e-14);
}

TEST(Distance, SamplesAreSpreadByArea) {
  // One triangle of area 8 and one of area 1/2.
  const TriangleMesh mesh{
      {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0), Vec3(9, 0, 0), Vec3(10, 0, 0), Vec3(9, 1, 0)},
      {{0, 1, 2}, {3, 4, 5}}};
  const auto samples = sample_by_area(mesh, 8500);
  const auto in_small =
      std::count_if(samples.begin(), samples.end(), [](const Vec3& p) { return p.x() >= 9; });
  EXPECT_NEAR(static_cast<double>(in_small), 500, 1);
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : samples)
    if (p.x() < 9) mean += p / (8500.0 - static_cast<double>(in_small));
  EXPECT_LT((mean - Vec3(4.0 / 3.0, 4.0 / 3.0, 0)).norm(), 0.01);  // the large triangle's centroid
}

}  // namespace
}  // namespace nanocarbon::mesh
