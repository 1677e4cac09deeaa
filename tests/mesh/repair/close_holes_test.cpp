// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/close_holes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "support/small_meshes.h"

namespace nanocarbon::mesh {
namespace {

//! A flat ring of triangles.
TriangleMesh annulus(double inner, double outer, VertexIndex columns) {
  TriangleMesh mesh;
  for (VertexIndex i = 0; i < columns; ++i) {
    const double angle = 2 * M_PI * i / columns;
    for (const double r : {inner, outer})
      mesh.points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.0);
    const VertexIndex a = 2 * i, b = 2 * ((i + 1) % columns);
    mesh.triangles.push_back({a, a + 1, b + 1});
    mesh.triangles.push_back({a, b + 1, b});
  }
  return mesh;
}

TEST(CloseHoles, ClosesWhatIsSmallerThanTheRadius) {
  TriangleMesh mesh = annulus(0.1, 1, 24);
  EXPECT_EQ(close_holes(mesh, 0.09), 0u);
  EXPECT_EQ(close_holes(mesh, 0.11), 1u);
  const MeshTopology topology = mesh_topology(mesh);
  EXPECT_EQ(topology.boundary_loops, 1u);
  EXPECT_TRUE(topology.manifold() && topology.consistently_wound());
  EXPECT_NEAR(area(mesh), 12 * std::sin(2 * M_PI / 24), 1e-12);  // of the regular 24-gon
}

TEST(CloseHoles, ATriangleThatIsMissingComesBack) {
  TriangleMesh mesh = test::tetrahedron();
  mesh.triangles.pop_back();
  EXPECT_EQ(close_holes(mesh, 10), 1u);
  EXPECT_TRUE(mesh_topology(mesh).closed());
  EXPECT_NEAR(signed_volume(mesh), 8.0 / 3.0, 1e-12);
  EXPECT_EQ(close_holes(mesh, 10), 0u);
}

}  // namespace
}  // namespace nanocarbon::mesh
