// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/close_holes.h"

#include <gtest/gtest.h>

#include <algorithm>
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

// A flat sheet in a cell, with a hole around each of some vertices.
TriangleMesh periodic_sheet(VertexIndex cells, const std::vector<VertexIndex>& holes) {
  TriangleMesh mesh;
  mesh.space = Space(orthogonal_cell(Vec3(cells, cells, 20), {true, true, false}));
  for (VertexIndex j = 0; j < cells; ++j)
    for (VertexIndex i = 0; i < cells; ++i) mesh.points.emplace_back(i, j, 0);
  const auto at = [&](VertexIndex i, VertexIndex j) { return j % cells * cells + i % cells; };
  const auto add = [&](const Triangle& t) {
    for (const VertexIndex v : t)
      if (std::find(holes.begin(), holes.end(), v) != holes.end()) return;
    mesh.triangles.push_back(t);
  };
  for (VertexIndex j = 0; j < cells; ++j)
    for (VertexIndex i = 0; i < cells; ++i) {
      add({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      add({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

TEST(CloseHoles, AcrossTheFacesOfACell) {
  TriangleMesh mesh = periodic_sheet(9, {0, 40});  // at the corner of the cell, and in its middle
  EXPECT_EQ(mesh_topology(mesh).boundary_loops, 2u);
  EXPECT_EQ(close_holes(mesh, 0.1), 0u);
  EXPECT_EQ(close_holes(mesh, 2), 2u);
  const MeshTopology topology = mesh_topology(mesh);
  EXPECT_TRUE(topology.closed());
  EXPECT_TRUE(topology.manifold() && topology.consistently_wound());
  EXPECT_NEAR(area(mesh), 81, 1e-9);
}

TEST(CloseHoles, NotWhatGoesRoundTheCell) {
  TriangleMesh ribbon = periodic_sheet(9, {});
  std::erase_if(ribbon.triangles, [&](const Triangle& t) { return t[0] < 9; });
  EXPECT_EQ(mesh_topology(ribbon).boundary_loops, 2u);
  EXPECT_EQ(close_holes(ribbon, 100), 0u);
}

}  // namespace
}  // namespace nanocarbon::mesh
