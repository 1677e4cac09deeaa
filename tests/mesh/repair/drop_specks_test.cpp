// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/drop_specks.h"

#include <gtest/gtest.h>

#include "support/small_meshes.h"

namespace nanocarbon::mesh {
namespace {

TEST(DropSpecks, SmallPiecesGoAndTheOthersStayAsTheyAre) {
  const TriangleMesh large = test::tetrahedron(), second = test::tetrahedron(Vec3(9, 0, 0));
  TriangleMesh mesh = test::together(test::together(test::tetrahedron(Vec3(5, 0, 0), 0.01), large),
                                     test::together(test::tetrahedron(Vec3(7, 0, 0), 0.02), second));
  const std::vector<double> areas = component_areas(mesh);
  ASSERT_EQ(areas.size(), 4u);
  EXPECT_NEAR(areas[1], 8 * std::sqrt(3.0), 1e-12);  // four triangles of edge sqrt(8)
  EXPECT_NEAR(areas[2], 4e-4 * areas[1], 1e-12);
  EXPECT_EQ(drop_specks(mesh, 0.1), 2u);
  const TriangleMesh expected = test::together(large, second);
  EXPECT_EQ(mesh.points, expected.points);
  EXPECT_EQ(mesh.triangles, expected.triangles);
  EXPECT_EQ(drop_specks(mesh, 0.1), 0u);
}

}  // namespace
}  // namespace nanocarbon::mesh
