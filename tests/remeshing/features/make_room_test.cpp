// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/features/make_room.h"

#include <gtest/gtest.h>

#include "nanocarbon/mesh/mesh_topology.h"
#include "remeshing/shapes.h"

namespace nanocarbon::features {
namespace {

//! Two spheres, the second wound and scaled as asked.
TriangleMesh shells(double inner, double outer) {
  TriangleMesh mesh = test::sphere(outer, 4);
  const TriangleMesh other = test::sphere(inner, 4);
  const auto shift = static_cast<VertexIndex>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (const Triangle& t : other.triangles)
    mesh.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return mesh;
}

TriangleMesh ellipsoid(double radius, double half_height) {
  TriangleMesh mesh = test::sphere(radius, 4);
  for (Vec3& p : mesh.points) p.z() *= half_height / radius;
  return mesh;
}

double height_at_axis(const TriangleMesh& mesh) {
  double low = 0, high = 0;
  for (const Vec3& p : mesh.points)
    if (std::hypot(p.x(), p.y()) < 1.5) {
      low = std::min(low, p.z());
      high = std::max(high, p.z());
    }
  return high - low;
}

TEST(RoomForSheets, LeavesWideShapesAlone) {
  EXPECT_FALSE(with_room_for_sheets(test::sphere(8, 4)).has_value());
  EXPECT_FALSE(with_room_for_sheets(test::torus(30, 6, 100, 40)).has_value());
}

TEST(RoomForSheets, AThinPlateGrowsToWhatCarbonTakes) {
  const TriangleMesh plate = ellipsoid(15, 1.4);
  const auto roomy = with_room_for_sheets(plate, 3.6);
  ASSERT_TRUE(roomy.has_value());
  EXPECT_NEAR(height_at_axis(*roomy), 3.6, 0.1);
  EXPECT_EQ(mesh::mesh_topology(*roomy).euler_characteristic, 2);
  double farthest = 0;
  for (std::size_t v = 0; v < plate.points.size(); ++v)
    farthest = std::max(farthest, (roomy->points[v] - plate.points[v]).norm());
  EXPECT_LT(farthest, 0.6 + 1e-9);
}

TEST(RoomForSheets, ShellsWithinEachOtherMoveApart) {
  const auto roomy = with_room_for_sheets(shells(10, 13), 3.6);
  ASSERT_TRUE(roomy.has_value());
  double inner = 0, outer = 100;
  for (const Vec3& p : roomy->points) {
    if (p.norm() < 11.5)
      inner = std::max(inner, p.norm());
    else
      outer = std::min(outer, p.norm());
  }
  EXPECT_NEAR(outer - inner, 3.6, 0.15);
}

}  // namespace
}  // namespace nanocarbon::features
