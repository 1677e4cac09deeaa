// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/split_in_four.h"

#include <gtest/gtest.h>

#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "support/small_meshes.h"

namespace nanocarbon::mesh {
namespace {

TEST(SplitInFour, KeepsTheSurface) {
  TriangleMesh square;
  square.points = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  for (const TriangleMesh& mesh : {square, test::tetrahedron()}) {
    const TriangleMesh fine = split_in_four(mesh);
    const MeshTopology before = mesh_topology(mesh), after = mesh_topology(fine);
    EXPECT_EQ(after.faces, 4 * before.faces);
    EXPECT_EQ(after.vertices, before.vertices + before.edges);
    EXPECT_EQ(after.euler_characteristic, before.euler_characteristic);
    EXPECT_EQ(after.boundary_loops, before.boundary_loops);
    EXPECT_TRUE(after.manifold() && after.orientable);
    EXPECT_TRUE(after.twisted_edges.empty());
    EXPECT_NEAR(area(fine), area(mesh), 1e-14);
  }
}

}  // namespace
}  // namespace nanocarbon::mesh
