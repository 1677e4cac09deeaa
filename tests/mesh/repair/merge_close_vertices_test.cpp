// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/merge_close_vertices.h"

#include <gtest/gtest.h>

#include "nanocarbon/mesh/join_points.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/shapes/shapes.h"
#include "support/small_meshes.h"

namespace nanocarbon::mesh {
namespace {

constexpr double anything = 1e9;  // every edge is shorter

std::size_t merge_all(TriangleMesh& mesh) {
  return merge_close_vertices(mesh, anything, MergedEdges::all, [](VertexIndex) { return true; });
}

// Two of its vertices in one would leave two triangles on the same corners, or none.
TEST(MergeCloseVertices, ATetrahedronIsNotMergedAway) {
  TriangleMesh tetrahedron = test::tetrahedron();
  EXPECT_EQ(merge_all(tetrahedron), 0u);
  EXPECT_EQ(tetrahedron.triangles, test::tetrahedron().triangles);
}

TEST(MergeCloseVertices, ATriangleIsNotMergedAway) {
  TriangleMesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(merge_all(triangle), 0u);
  EXPECT_EQ(triangle.triangles.size(), 1u);
}

// However much is merged, the surface stays a closed one of its genus.
TEST(MergeCloseVertices, ABallStaysOneDownToFourTriangles) {
  TriangleMesh ball = shapes::make_sphere(1.0, 4);
  const std::size_t vertices = ball.points.size();
  const std::size_t merged = merge_all(ball);
  EXPECT_GT(merged, vertices / 2);
  EXPECT_GE(ball.triangles.size(), 4u);
  drop_unused_points(ball);
  EXPECT_EQ(ball.points.size() + merged, vertices);
  const MeshTopology topology = mesh_topology(ball);
  EXPECT_TRUE(topology.manifold() && topology.closed());
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.genus, 0);
}

}  // namespace
}  // namespace nanocarbon::mesh
