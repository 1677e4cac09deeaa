// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/triangulate.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "nanocarbon/mesh/drop_faces.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/self_intersections.h"
#include "support/small_meshes.h"

namespace nanocarbon::mesh {
namespace {

PolygonSoup one_face(std::vector<Vec3> points) {
  std::vector<VertexIndex> face(points.size());
  for (std::size_t i = 0; i < face.size(); ++i) face[i] = static_cast<VertexIndex>(i);
  return test::soup(std::move(points), {face});
}

double newell_area(const PolygonSoup& soup) { return 0.5 * newell_normal(soup.points, soup.face(0)).norm(); }

// A flat polygon's triangles cover it: their areas add up to its own (they would add up to more if one stuck
// out), none is turned, and none lies on another.
void expect_covered(const PolygonSoup& soup) {
  const TriangleMesh mesh = triangulate(soup).mesh;
  ASSERT_EQ(mesh.triangles.size(), soup.points.size() - 2);
  const Vec3 normal = newell_normal(soup.points, soup.face(0));
  for (const auto& [a, b, c] : mesh.triangles)
    EXPECT_GT(area_normal(mesh.points[a], mesh.points[b], mesh.points[c]).dot(normal), 0.0);
  EXPECT_NEAR(area(mesh), newell_area(soup), 1e-12 * newell_area(soup));
  EXPECT_THAT(self_intersections(mesh).pairs, testing::IsEmpty());
  const MeshTopology topology = mesh_topology(mesh);
  EXPECT_TRUE(topology.manifold());
  EXPECT_EQ(topology.euler_characteristic, 1);
}

TEST(Triangulate, ConvexAndConcavePolygonsAreCovered) {
  expect_covered(one_face({Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 1, 0), Vec3(0, 1, 0)}));
  expect_covered(one_face({Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(1, 1, 0), Vec3(0, 4, 0)}));  // an arrowhead
  expect_covered(
      one_face({Vec3(0, 0, 0), Vec3(0, 4, 0), Vec3(1, 1, 0), Vec3(4, 0, 0)}));  // the other way round
  expect_covered(
      one_face({Vec3(1, 1, 0), Vec3(4, 0, 0), Vec3(0, 0, 0), Vec3(0, 4, 0)}));  // from another corner on
}

TEST(Triangulate, AStarAndACombAndASpiralAreCoveredHoweverTheyLie) {
  std::vector<Vec3> star, comb, spiral;
  for (int i = 0; i < 14; ++i) {
    const double r = i % 2 ? 1.0 : 3.0;
    star.emplace_back(r * std::cos(M_PI * i / 7), r * std::sin(M_PI * i / 7), 0);
  }
  for (int i = 0; i < 20; ++i) comb.emplace_back(i, i % 2 ? 5.0 : 1.0, 0);
  comb.emplace_back(19, 0, 0);
  comb.emplace_back(0, 0, 0);
  for (int i = 0; i < 60; ++i)
    spiral.emplace_back((2 + 0.1 * i) * std::cos(0.2 * i), (2 + 0.1 * i) * std::sin(0.2 * i), 0);
  for (int i = 59; i >= 0; --i)
    spiral.emplace_back((1.3 + 0.1 * i) * std::cos(0.2 * i), (1.3 + 0.1 * i) * std::sin(0.2 * i), 0);
  for (std::vector<Vec3> points : {star, comb, spiral}) {
    // A rotation with rational sines and cosines, which keeps a flat polygon flat but for the last digits.
    for (Vec3& p : points) p = Vec3(0.6 * p.x() - 0.8 * p.y(), 0.8 * p.x() + 0.6 * p.y(), 0.0);
    expect_covered(one_face(points));
    std::reverse(points.begin(), points.end());
    expect_covered(one_face(points));
    for (Vec3& p : points) p = Vec3(p.z(), p.x(), p.y());
    expect_covered(one_face(points));
  }
}

TEST(Triangulate, CornersOnAStraightSideDoNotGiveTrianglesWithoutArea) {
  expect_covered(one_face({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(2, 2, 0), Vec3(0, 2, 0)}));
  expect_covered(
      one_face({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0), Vec3(3, 1, 0), Vec3(0, 1, 0)}));
}

TEST(Triangulate, AQuadIsCutAlongTheDiagonalThatGivesBetterTriangles) {
  const TriangleMesh mesh =
      triangulate(one_face({Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(11, 1, 0), Vec3(1, 1, 0)})).mesh;
  for (const Triangle& t : mesh.triangles) {  // the long diagonal from 0 to 2 is in neither
    EXPECT_FALSE(std::count(t.begin(), t.end(), 0u) && std::count(t.begin(), t.end(), 2u));
  }
}

TEST(Triangulate, ADiagonalThatIsAnEdgeElsewhereIsAvoided) {
  // Two slanted quads with the same four vertices, a pillow: both would best be cut from 1 to 3.
  const PolygonSoup pillow = test::soup({Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(11, 1, 0), Vec3(1, 1, 0)},
                                        {{0, 1, 2, 3}, {3, 2, 1, 0}});
  const Triangulated result = triangulate(pillow);
  EXPECT_EQ(result.centres_added, 2u);
  const MeshTopology topology = mesh_topology(result.mesh);
  EXPECT_TRUE(topology.manifold() && topology.closed());
  EXPECT_EQ(topology.euler_characteristic, 2);
}

TEST(Triangulate, APolygonThatCrossesItselfStillGivesADisc) {
  const Triangulated result =
      triangulate(one_face({Vec3(0, 0, 0), Vec3(2, 2, 0), Vec3(2, 0, 0), Vec3(0, 2, 0), Vec3(-1, 1, 0)}));
  EXPECT_EQ(result.mesh.triangles.size(), 3u);
  EXPECT_EQ(mesh_topology(result.mesh).euler_characteristic, 1);
  const Triangulated flat = triangulate(one_face(std::vector<Vec3>(6, Vec3(1, 2, 3))));
  EXPECT_EQ(flat.mesh.triangles.size(), 4u);
}

TEST(Triangulate, AFaceMayGoAroundAHoleAlongABridge) {
  std::vector<Vec3> points;  // a square of 4 x 4 with a square hole of 2 x 2
  for (const double r : {2.0, 1.0})
    points.insert(points.end(), {Vec3(-r, -r, 0), Vec3(r, -r, 0), Vec3(r, r, 0), Vec3(-r, r, 0)});
  const PolygonSoup soup = test::soup(points, {{0, 1, 2, 3, 0, 4, 7, 6, 5, 4}});
  const TriangleMesh mesh = triangulate(soup).mesh;
  EXPECT_DOUBLE_EQ(area(mesh), 12.0);
  EXPECT_THAT(self_intersections(mesh).pairs, testing::IsEmpty());
  const MeshTopology topology = mesh_topology(mesh);
  EXPECT_TRUE(topology.manifold() && topology.consistently_wound());
  EXPECT_EQ(topology.euler_characteristic, 0);
  EXPECT_EQ(topology.boundary_loops, 2u);
}

TEST(DropRepeatedVertices, SpikesAreTakenOutAndBridgesStay) {
  PolygonSoup soup =
      test::soup(std::vector<Vec3>(9, Vec3::Zero()), {{0, 1, 3, 1, 2},  // to 3 and back
                                                      {3, 1, 2, 0, 1},  // the same from another corner on
                                                      {1, 2, 0, 1, 3},
                                                      {0, 1, 0, 1},                // nothing is left
                                                      {0, 1, 4, 5, 4, 1, 2},       // two steps there and back
                                                      {0, 1, 2, 0, 4, 3, 5, 4}});  // a bridge
  EXPECT_EQ(drop_repeated_vertices(soup), 5u);
  ASSERT_EQ(soup.faces(), 5u);
  for (std::size_t face = 0; face < 4; ++face) {
    EXPECT_EQ(soup.face(face).size(), 3u);
    EXPECT_THAT(soup.face(face), testing::UnorderedElementsAre(0, 1, 2));
  }
  EXPECT_EQ(soup.face(4).size(), 8u);
}

TEST(Triangulate, NoTriangleRepeatsAVertexAndNoVertexIsLeftOver) {
  // Cycles over few vertices, so that they pass through them again and again.
  std::mt19937_64 random(4);
  for (int i = 0; i < 500; ++i) {
    std::vector<VertexIndex> face(4 + random() % 6);
    for (VertexIndex& v : face) v = static_cast<VertexIndex>(random() % 5);
    const std::vector<Vec3> points = {Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(2, 2, 1), Vec3(0, 3, 0),
                                      Vec3(1, 1, 0)};
    const TriangleMesh mesh = triangulate(test::soup(points, {{0, 1, 2}, {2, 3, 4}, face})).mesh;
    std::vector<bool> used(mesh.points.size(), false);
    for (const Triangle& t : mesh.triangles) {
      EXPECT_TRUE(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
      for (const VertexIndex v : t) used[v] = true;
    }
    EXPECT_THAT(used, testing::Each(true));
  }
}

TEST(Triangulate, TrianglesKeepTheirPlacesAndPolygonsTheirs) {
  const PolygonSoup soup = test::soup(
      {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(2, 0, 0)}, {{1, 4, 2}, {0, 1, 2, 3}});
  const Triangulated result = triangulate(soup);
  EXPECT_EQ(result.polygons, 1u);
  EXPECT_EQ(result.mesh.triangles[0], (Triangle{1, 4, 2}));
  EXPECT_EQ(result.mesh.triangles.size(), 3u);
}

TEST(Triangulate, LargePolygonsTakeBoundedTime) {
  std::vector<Vec3> comb;  // half of its corners are not convex
  for (int i = 0; i < 2000; ++i) comb.emplace_back(i, i % 2 ? 5.0 : 1.0, 0);
  comb.emplace_back(1999, 0, 0);
  comb.emplace_back(0, 0, 0);
  const PolygonSoup soup = one_face(comb);
  EXPECT_NEAR(area(triangulate(soup).mesh), newell_area(soup), 1e-9 * newell_area(soup));
  EXPECT_FALSE(can_be_triangulated(one_face(std::vector<Vec3>(most_corners + 1, Vec3::Zero()))));
}

}  // namespace
}  // namespace nanocarbon::mesh
