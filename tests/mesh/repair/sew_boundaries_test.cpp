// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/sew_boundaries.h"

#include <gmock/gmock.h>

#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/repair/repair_surface.h"
#include "nanocarbon/mesh/triangulate.h"
#include "support/small_meshes.h"

namespace nanocarbon::mesh {
namespace {

// A cube whose square at y = 0 is two halves, while the neighbours know nothing of the vertices between them:
// T-junctions at (0.5, 0, 0) and (0.5, 0, 1).
PolygonSoup cube_with_junctions(double off = 0.0) {
  PolygonSoup soup = test::cube();
  soup.points.emplace_back(0.5, off, 0);
  soup.points.emplace_back(0.5, 0, 1 + off);
  return test::soup(
      soup.points,
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 8, 9, 4}, {8, 1, 5, 9}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

TEST(SewBoundaries, TJunctionsAreClosed) {
  for (const double off : {0.0, 1e-7, 1e-5, 1e-4}) {
    const RepairedSurface repaired = repair_surface(cube_with_junctions(off));
    EXPECT_TRUE(repaired.diagnosis.topology.closed()) << off;
    EXPECT_TRUE(repaired.diagnosis.usable()) << off;
    EXPECT_EQ(repaired.diagnosis.topology.vertices, 10u) << off;
    EXPECT_NEAR(repaired.diagnosis.volume.value_or(0), 1.0, 1e-3) << off;
    EXPECT_THAT(repaired.mended, testing::Contains(testing::HasSubstr("sewed boundaries")));
  }
}

// Wherever it lies: also on the side of the face that it is no corner of any more, where a slit remained once.
TEST(SewBoundaries, ACornerThatIsNotQuiteInItsPlaceIsPutThere) {
  for (const double size : {1e-7, 1e-6, 1e-5, 1e-4})
    for (const Vec3& off :
         {Vec3(1, 0, 0), Vec3(1, 0.5, 0), Vec3(0, 1, 0), Vec3(0, 0, -1), Vec3(-1, -0.5, 1)}) {
      TriangleMesh cube = triangulate(test::cube()).mesh;
      cube.points.push_back(cube.points[cube.triangles[0][0]] + size * off);
      cube.triangles[0][0] = 8;
      PolygonSoup soup = soup_of(cube);
      EXPECT_TRUE(sew_boundaries(soup));
      EXPECT_EQ(soup.points.size(), 8u) << size << " times " << off.transpose();
      EXPECT_TRUE(mesh_topology(soup, edge_table(soup)).closed());
    }
}

TEST(SewBoundaries, AGapThatCanBeSeenStaysOpen) {
  EXPECT_FALSE(repair_surface(cube_with_junctions(0.05)).diagnosis.topology.closed());
}

TEST(SewBoundaries, WhatIsClosedOrMeantToBeOpenStaysAsItIs) {
  PolygonSoup closed = test::cube();
  EXPECT_FALSE(sew_boundaries(closed));
  PolygonSoup open = test::soup({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}, {{0, 1, 2, 3}});
  EXPECT_FALSE(sew_boundaries(open));
}

// Patches of CAD that end in rows of their own along their common curve.
TEST(SewBoundaries, PatchesOfOtherFinenessMeetAlongAStraightSeam) {
  PolygonSoup soup;
  const auto strip = [&](double y0, double y1, int parts) {
    const auto first = static_cast<VertexIndex>(soup.points.size());
    for (int i = 0; i <= parts; ++i)
      for (const double y : {y0, y1}) soup.points.emplace_back(12.0 * i / parts, y, 0.0);
    for (int i = 0; i < parts; ++i) {
      const auto a = first + 2 * static_cast<VertexIndex>(i);
      for (const VertexIndex v : {a, a + 2, a + 3, a + 1}) soup.corners.push_back(v);
      soup.close_face();
    }
  };
  strip(0, 1, 3);
  strip(1, 2, 4);
  const RepairedSurface repaired = repair_surface(soup);
  EXPECT_EQ(repaired.diagnosis.topology.components, 1u);
  EXPECT_EQ(repaired.diagnosis.topology.boundary_loops, 1u);
  EXPECT_DOUBLE_EQ(repaired.diagnosis.area, 24.0);
}

}  // namespace
}  // namespace nanocarbon::mesh
