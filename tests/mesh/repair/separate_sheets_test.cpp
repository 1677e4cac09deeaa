// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/separate_sheets.h"

#include <gtest/gtest.h>

#include <array>

#include "nanocarbon/mesh/join_points.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/repair/repair_surface.h"
#include "support/small_meshes.h"

namespace nanocarbon::mesh {
namespace {

using Cell = std::array<int, 3>;

//! The surface of unit cubes on a grid: every square between a full and an empty cell, vertices shared by place,
//! as programs make it of segmented images.
PolygonSoup surface_of_cells(const std::vector<Cell>& full) {
  PolygonSoup soup;
  const auto is_full = [&](const Cell& c) { return std::find(full.begin(), full.end(), c) != full.end(); };
  for (const Cell& cell : full)
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        Cell next = cell;
        next[axis] += side ? 1 : -1;
        if (is_full(next)) continue;
        Vec3 corner(cell[0], cell[1], cell[2]), u = Vec3::Zero(), v = Vec3::Zero();
        corner[axis] += side;
        u[(axis + 1) % 3] = 1;
        v[(axis + 2) % 3] = 1;
        if (!side) std::swap(u, v);
        for (const Vec3& p : {corner, Vec3(corner + u), Vec3(corner + u + v), Vec3(corner + v)}) {
          soup.corners.push_back(static_cast<VertexIndex>(soup.points.size()));
          soup.points.push_back(p);
        }
        soup.close_face();
      }
  join(soup, coincident_points(soup.points));
  return soup;
}

MeshTopology topology_of(const PolygonSoup& soup) { return mesh_topology(soup, edge_table(soup)); }

TEST(SeparateSheets, ASoundMeshStaysAsItIs) {
  PolygonSoup soup = test::torus(12, 8);
  const PolygonSoup before = soup;
  const SeparatedSheets done = separate_sheets(soup);
  EXPECT_EQ(done.edges + done.vertices, 0u);
  EXPECT_EQ(soup.points, before.points);
  EXPECT_EQ(soup.corners, before.corners);
}

TEST(SeparateSheets, CubesThatShareAnEdgeComeApart) {
  PolygonSoup soup = surface_of_cells({{0, 0, 0}, {1, 1, 0}});
  ASSERT_EQ(topology_of(soup).non_manifold_edges.size(), 1u);
  EXPECT_EQ(separate_sheets(soup).edges, 1u);
  const MeshTopology t = topology_of(soup);
  EXPECT_TRUE(t.manifold() && t.closed() && t.consistently_wound());
  EXPECT_EQ(t.components, 2u);
  EXPECT_EQ(t.euler_characteristic, 4);
  EXPECT_DOUBLE_EQ(signed_volume(soup), 2.0);
}

TEST(SeparateSheets, CubesThatShareAVertexComeApart) {
  PolygonSoup soup = surface_of_cells({{0, 0, 0}, {1, 1, 1}});
  const SeparatedSheets done = separate_sheets(soup);
  EXPECT_EQ(done.edges, 0u);
  EXPECT_EQ(done.vertices, 1u);
  const MeshTopology t = topology_of(soup);
  EXPECT_TRUE(t.manifold() && t.closed());
  EXPECT_EQ(t.euler_characteristic, 4);
}

// Two cells that touch in an edge and hang together over others at both of its ends: a ring of material around
// the edge, above and below it, so that the edge needs a vertex in the middle.
TEST(SeparateSheets, SheetsThatHangTogetherAtBothEndsOfTheirEdgeGetAVertexInBetween) {
  std::vector<Cell> cells;
  for (const int z : {0, 2})
    for (const int x : {0, 1})
      for (const int y : {0, 1}) cells.push_back({x, y, z});
  cells.push_back({0, 0, 1});
  cells.push_back({1, 1, 1});
  PolygonSoup soup = surface_of_cells(cells);
  ASSERT_EQ(topology_of(soup).non_manifold_edges.size(), 1u);
  EXPECT_EQ(separate_sheets(soup).edges, 1u);
  const MeshTopology t = topology_of(soup);
  EXPECT_TRUE(t.manifold() && t.closed() && t.consistently_wound());
  EXPECT_EQ(t.components, 1u);
  EXPECT_EQ(t.genus, 1);  // two plates with two posts between them
  EXPECT_NEAR(signed_volume(soup), 10.0, 1e-12);
  const RepairedSurface repaired = repair_surface(surface_of_cells(cells));
  EXPECT_TRUE(repaired.diagnosis.usable());
  EXPECT_EQ(repaired.diagnosis.topology.genus, 1);
  EXPECT_NEAR(repaired.diagnosis.area, 2 * 16 - 4 + 8, 1e-12);
}

TEST(SeparateSheets, TheSameFromAMeshThatIsInsideOut) {
  PolygonSoup soup = surface_of_cells({{0, 0, 0}, {1, 1, 0}, {0, 0, 1}});
  for (std::size_t face = 0; face < soup.faces(); ++face)
    std::reverse(soup.corners.begin() + soup.offsets[face], soup.corners.begin() + soup.offsets[face + 1]);
  separate_sheets(soup);
  EXPECT_EQ(topology_of(soup).components, 2u);
  EXPECT_TRUE(topology_of(soup).manifold());
}

TEST(SeparateSheets, AFinIsLeftAlone) {
  PolygonSoup soup = test::cube();
  soup.points.emplace_back(0.5, -1, -1);
  for (const VertexIndex v : {0u, 1u, 8u}) soup.corners.push_back(v);
  soup.close_face();
  EXPECT_EQ(separate_sheets(soup).edges, 0u);
  EXPECT_EQ(topology_of(soup).non_manifold_edges.size(), 1u);
}

}  // namespace
}  // namespace nanocarbon::mesh
