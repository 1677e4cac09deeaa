// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/mesh_topology.h"

#include <gmock/gmock.h>

#include "nanocarbon/mesh/triangulate.h"
#include "support/small_meshes.h"

namespace nanocarbon::mesh {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

MeshTopology topology_of(const PolygonSoup& soup) { return mesh_topology(soup, edge_table(soup)); }

TEST(MeshTopology, ATetrahedronIsASphere) {
  const MeshTopology topology = mesh_topology(test::tetrahedron());
  EXPECT_EQ(topology.vertices, 4u);
  EXPECT_EQ(topology.edges, 6u);
  EXPECT_EQ(topology.faces, 4u);
  EXPECT_EQ(topology.euler_characteristic, 2);
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.genus, 0);
  EXPECT_TRUE(topology.closed() && topology.orientable && topology.manifold() &&
              topology.consistently_wound());
}

TEST(MeshTopology, PolygonsCountAsTheyAreAndTrianglesGiveTheSameSurface) {
  for (const PolygonSoup& soup : {test::torus(7, 5), test::cube()}) {
    const MeshTopology polygons = topology_of(soup);
    const MeshTopology triangles = mesh_topology(triangulate(soup).mesh);
    EXPECT_EQ(polygons.euler_characteristic, triangles.euler_characteristic);
    EXPECT_EQ(polygons.genus, triangles.genus);
    EXPECT_EQ(2 * polygons.faces, triangles.faces);
  }
  EXPECT_EQ(topology_of(test::torus(7, 5)).genus, 1);
  EXPECT_EQ(topology_of(test::cube()).genus, 0);
}

TEST(MeshTopology, HolesAreBoundaryLoops) {
  PolygonSoup soup = test::torus(8, 6);
  const auto without = [&](const std::vector<std::size_t>& faces) {
    PolygonSoup kept;
    kept.points = soup.points;
    for (std::size_t f = 0; f < soup.faces(); ++f) {
      if (std::find(faces.begin(), faces.end(), f) != faces.end()) continue;
      kept.corners.insert(kept.corners.end(), soup.face(f).begin(), soup.face(f).end());
      kept.close_face();
    }
    return topology_of(kept);
  };
  const MeshTopology holes = without({0, 20});
  EXPECT_EQ(holes.boundary_loops, 2u);
  EXPECT_EQ(holes.genus, 1);
  EXPECT_EQ(holes.euler_characteristic, -2);
  EXPECT_FALSE(holes.closed());
  // Two holes that touch in a vertex: that vertex has two fans.
  const MeshTopology touching = without({0, 7});
  EXPECT_THAT(touching.non_manifold_vertices, SizeIs(1));
}

TEST(MeshTopology, PiecesHaveTheirOwnGenus) {
  const MeshTopology topology =
      mesh_topology(test::together(triangulate(test::torus(6, 5)).mesh, test::tetrahedron(Vec3(9, 9, 9))));
  ASSERT_EQ(topology.components, 2u);
  EXPECT_EQ(topology.component[0].genus(), 1);
  EXPECT_EQ(topology.component[1].genus(), 0);
  EXPECT_EQ(topology.genus, 1);
  EXPECT_EQ(topology.euler_characteristic, 2);
  EXPECT_EQ(topology.component_of_face.back(), 1u);
}

TEST(MeshTopology, AMoebiusStripAndAKleinBottleAreNotOrientable) {
  // A strip of n quads whose ends are joined with a half turn.
  PolygonSoup strip;
  const VertexIndex n = 6;
  for (VertexIndex i = 0; i < n; ++i) {
    strip.points.push_back(Vec3(i, 0, 0));
    strip.points.push_back(Vec3(i, 1, 0));
  }
  for (VertexIndex i = 0; i < n; ++i) {
    const bool last = i + 1 == n;
    for (const VertexIndex v : {2 * i, last ? 1 : 2 * i + 2, last ? 0 : 2 * i + 3, 2 * i + 1})
      strip.corners.push_back(v);
    strip.close_face();
  }
  const MeshTopology moebius = topology_of(strip);
  EXPECT_FALSE(moebius.orientable);
  EXPECT_EQ(moebius.boundary_loops, 1u);
  EXPECT_EQ(moebius.component[0].genus(), 1);  // one cross-cap

  // A torus whose last column is joined the other way round.
  PolygonSoup klein;
  klein.points.resize(36, Vec3::Zero());
  for (VertexIndex i = 0; i < 6; ++i)
    for (VertexIndex j = 0; j < 6; ++j) {
      const auto vertex = [](VertexIndex a, VertexIndex b) {
        return a == 6 ? (6 - b % 6) % 6 : a * 6 + b % 6;
      };
      for (const VertexIndex v : {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)})
        klein.corners.push_back(v);
      klein.close_face();
    }
  const MeshTopology bottle = topology_of(klein);
  EXPECT_FALSE(bottle.orientable);
  EXPECT_TRUE(bottle.closed());
  EXPECT_EQ(bottle.euler_characteristic, 0);
  EXPECT_EQ(bottle.component[0].genus(), 2);  // two cross-caps
}

TEST(MeshTopology, OneTurnedFaceIsNoQuestionOfOrientability) {
  TriangleMesh mesh = test::tetrahedron();
  std::swap(mesh.triangles[2][0], mesh.triangles[2][1]);
  const MeshTopology topology = mesh_topology(mesh);
  EXPECT_TRUE(topology.orientable);
  EXPECT_FALSE(topology.consistently_wound());
  EXPECT_THAT(topology.twisted_edges, SizeIs(3));
}

TEST(MeshTopology, NonManifoldPlacesAreFound) {
  // Two tetrahedra with one edge, or one vertex, in common.
  TriangleMesh edge = test::together(test::tetrahedron(), test::tetrahedron(Vec3(5, 5, 5)));
  const auto rename = [](TriangleMesh mesh, VertexIndex from, VertexIndex to) {
    for (Triangle& t : mesh.triangles)
      for (VertexIndex& v : t)
        if (v == from) v = to;
    return mesh;
  };
  const TriangleMesh vertex = rename(edge, 4, 0);
  EXPECT_THAT(mesh_topology(vertex).non_manifold_vertices, ElementsAre(0));
  EXPECT_THAT(mesh_topology(vertex).non_manifold_edges, IsEmpty());
  EXPECT_EQ(mesh_topology(vertex).components, 2u);
  edge = rename(vertex, 5, 1);
  EXPECT_THAT(mesh_topology(edge).non_manifold_edges, SizeIs(1));
  EXPECT_EQ(mesh_topology(edge).components, 1u);
}

TEST(MeshTopology, NothingIsNothing) {
  const MeshTopology topology = mesh_topology(TriangleMesh{});
  EXPECT_EQ(topology.components, 0u);
  EXPECT_FALSE(topology.closed());
}

}  // namespace
}  // namespace nanocarbon::mesh
