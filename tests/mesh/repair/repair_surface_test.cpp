// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/repair_surface.h"

#include <gmock/gmock.h>

#include <cmath>

#include "nanocarbon/mesh/formats/load_surface.h"
#include "nanocarbon/mesh/triangulate.h"
#include "support/refusal.h"
#include "support/small_meshes.h"
#include "support/temporary_folder.h"

namespace nanocarbon::mesh {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A soup in which no two faces share a vertex, as an STL has it.
PolygonSoup torn(const TriangleMesh& mesh) {
  PolygonSoup soup;
  for (const Triangle& triangle : mesh.triangles) {
    for (const VertexIndex v : triangle) {
      soup.corners.push_back(static_cast<VertexIndex>(soup.points.size()));
      soup.points.push_back(mesh.points[v]);
    }
    soup.close_face();
  }
  return soup;
}

double volume(const TriangleMesh& mesh) { return signed_volume(mesh); }

TEST(Surface, ASoundMeshStaysAsItIs) {
  const TriangleMesh mesh = test::tetrahedron();
  const RepairedSurface repaired = repair_surface(soup_of(mesh));
  EXPECT_EQ(repaired.mesh.points, mesh.points);
  EXPECT_EQ(repaired.mesh.triangles, mesh.triangles);
  EXPECT_THAT(repaired.repairs, IsEmpty());
  EXPECT_THAT(repaired.diagnosis.findings, IsEmpty());
}

TEST(Surface, PolygonsAreCut) {
  const RepairedSurface repaired = repair_surface(test::cube());
  EXPECT_THAT(repaired.repairs, ElementsAre("cut polygons into triangles: 6"));
  EXPECT_EQ(repaired.mesh.triangles.size(), 12u);
  EXPECT_DOUBLE_EQ(volume(repaired.mesh), 1.0);
  EXPECT_DOUBLE_EQ(repaired.diagnosis.area, 6.0);
  EXPECT_TRUE(repaired.diagnosis.usable());
}

TEST(Surface, AnInsideOutMeshIsTurned) {
  const RepairedSurface repaired = repair_surface(soup_of(test::turned(test::tetrahedron())));
  EXPECT_THAT(repaired.repairs, ElementsAre(HasSubstr("inside-out")));
  EXPECT_NEAR(volume(repaired.mesh), 8.0 / 3.0, 1e-14);
}

TEST(Surface, FacesWoundAgainstTheOthersAreTurned) {
  TriangleMesh mesh = triangulate(test::torus(12, 8)).mesh;
  const double right = volume(mesh);
  for (const std::size_t t : {3u, 4u, 50u, 91u}) std::swap(mesh.triangles[t][0], mesh.triangles[t][2]);
  const RepairedSurface repaired = repair_surface(soup_of(mesh));
  EXPECT_THAT(repaired.repairs, ElementsAre("turned faces that were wound against the others: 4"));
  EXPECT_DOUBLE_EQ(volume(repaired.mesh), right);
}

TEST(Surface, TheWallOfACavityKeepsItsWindingAndSoDoesAShell) {
  const TriangleMesh outer = test::tetrahedron(Vec3::Zero(), 10.0), inner = test::tetrahedron();
  const double big = volume(outer), small = volume(inner);
  const auto loaded = [](const TriangleMesh& mesh) { return repair_surface(soup_of(mesh)); };
  const RepairedSurface cavity = loaded(test::together(outer, test::turned(inner)));
  EXPECT_THAT(cavity.repairs, IsEmpty());
  EXPECT_NEAR(volume(cavity.mesh), big - small, 1e-9);
  const RepairedSurface shell = loaded(test::together(inner, outer));
  EXPECT_THAT(shell.repairs, IsEmpty());
  EXPECT_NEAR(volume(shell.mesh), big + small, 1e-9);
  // Inside-out as a whole: both are turned, and stay what they are to each other.
  const RepairedSurface turned = loaded(test::together(test::turned(outer), inner));
  EXPECT_THAT(turned.repairs, ElementsAre("turned closed pieces that were inside-out: 2"));
  EXPECT_NEAR(volume(turned.mesh), big - small, 1e-9);
  EXPECT_TRUE(turned.diagnosis.usable());
}

TEST(Surface, PiecesBesideEachOtherAreTurnedEachForItself) {
  const RepairedSurface repaired = repair_surface(
      soup_of(test::together(test::turned(test::tetrahedron()), test::tetrahedron(Vec3(20, 0, 0)))));
  EXPECT_THAT(repaired.repairs, ElementsAre("turned closed pieces that were inside-out: 1"));
  EXPECT_NEAR(volume(repaired.mesh), 16.0 / 3.0, 1e-12);
}

TEST(Surface, PiecesThatIntersectAreRefused) {
  const RepairedSurface repaired =
      repair_surface(soup_of(test::together(test::tetrahedron(), test::tetrahedron(Vec3(0.5, 0.1, 0.2)))));
  EXPECT_NE(repaired.diagnosis.find(MeshProblem::components_intersect), nullptr);
  EXPECT_FALSE(repaired.diagnosis.usable());
}

TEST(Surface, TrianglesWithoutCommonVerticesAreJoined) {
  PolygonSoup soup = torn(triangulate(test::torus(12, 8)).mesh);
  const RepairedSurface repaired = repair_surface(soup);
  EXPECT_EQ(repaired.diagnosis.topology.vertices, 96u);
  EXPECT_EQ(repaired.diagnosis.topology.genus, 1);
  EXPECT_TRUE(repaired.diagnosis.topology.closed() && repaired.diagnosis.usable());
  EXPECT_THAT(repaired.repairs,
              ElementsAre("joined vertices to others at the same place: 480"));  // 576 corners, 96 vertices
}

TEST(Surface, ASeamIsJoinedAndSolidsThatTouchStayApart) {
  // A cube in two halves that were cut apart; and two closed cubes that touch along an edge.
  PolygonSoup halves = test::cube();
  const PolygonSoup whole = halves;
  for (std::size_t corner = 12; corner < 24; ++corner) halves.corners[corner] += 8;
  halves.points.insert(halves.points.end(), whole.points.begin(), whole.points.end());
  EXPECT_TRUE(repair_surface(halves).diagnosis.topology.closed());
  const TriangleMesh cube = triangulate(whole).mesh, other = triangulate(test::cube(Vec3(1, 1, 0))).mesh;
  const RepairedSurface touching = repair_surface(soup_of(test::together(cube, other)));
  EXPECT_EQ(touching.diagnosis.topology.components, 2u);
  EXPECT_TRUE(touching.diagnosis.topology.manifold());
  EXPECT_TRUE(touching.diagnosis.usable());
  EXPECT_NE(touching.diagnosis.find(MeshProblem::duplicate_vertex), nullptr);  // a warning
}

TEST(Surface, NearlyCoincidentVerticesJoin) {
  PolygonSoup soup = torn(triangulate(test::torus(12, 8)).mesh);
  for (std::size_t i = 0; i < soup.points.size(); ++i) soup.points[i].x() += (i % 3 == 0 ? 1e-7 : 0.0);
  const RepairedSurface joined = repair_surface(soup);
  EXPECT_TRUE(joined.diagnosis.topology.closed() && joined.diagnosis.usable());
  EXPECT_THAT(joined.repairs, testing::Contains(HasSubstr(" within ")));
}

// Of longitudes and latitudes: at the poles and along the seam the places differ by the rounding of sine and cosine.
TEST(Surface, TheRoundedPolesOfASphereAreJoined) {
  constexpr int longitudes = 32, latitudes = 16;
  PolygonSoup sphere;
  for (int j = 0; j <= latitudes; ++j)
    for (int i = 0; i <= longitudes; ++i) {
      const double u = 2 * M_PI * i / longitudes, v = M_PI * j / latitudes;
      sphere.points.emplace_back(std::sin(v) * std::cos(u), std::sin(v) * std::sin(u), std::cos(v));
    }
  for (VertexIndex j = 0; j < latitudes; ++j)
    for (VertexIndex i = 0; i < longitudes; ++i) {
      const VertexIndex a = j * (longitudes + 1) + i, b = a + longitudes + 1;
      for (const VertexIndex v : {a, b, b + 1, a, b + 1, a + 1}) {
        sphere.corners.push_back(v);
        if (sphere.corners.size() % 3 == 0) sphere.close_face();
      }
    }
  const RepairedSurface repaired = repair_surface(sphere);
  EXPECT_TRUE(repaired.diagnosis.usable());
  EXPECT_TRUE(repaired.diagnosis.topology.closed());
  EXPECT_EQ(repaired.diagnosis.topology.genus, 0);
  EXPECT_EQ(repaired.mesh.points.size(), longitudes * (latitudes - 1) + 2u);
}

TEST(Surface, RubbishThatChangesNothingIsDropped) {
  PolygonSoup soup = soup_of(test::tetrahedron());
  soup.points.insert(soup.points.begin(), Vec3(7, 7, 7));  // in no face
  for (VertexIndex& corner : soup.corners) ++corner;
  const auto add = [&](std::vector<VertexIndex> face) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.close_face();
  };
  add({1, 1, 2});
  add({4, 2, 4, 3});
  add({3, 3, 3});
  add({2, 3, 1});  // face 0 again, from another corner on
  const RepairedSurface repaired = repair_surface(soup);
  EXPECT_EQ(repaired.mesh.points, test::tetrahedron().points);
  EXPECT_EQ(repaired.mesh.triangles, test::tetrahedron().triangles);
  EXPECT_THAT(repaired.repairs,
              ElementsAre("repaired or dropped faces that repeat a vertex: 3", "dropped duplicate faces: 1",
                          "dropped vertices that no face uses: 1"));
}

TEST(Surface, FacesWithoutAreaAreRemovedByFlips) {
  // A vertex in the middle of the cube's edge from 0 to 1, which only one of the two squares there has: the
  // other one is kept apart by a triangle that is a line.
  PolygonSoup soup = test::cube();
  soup.points.emplace_back(0.5, 0.0, 0.0);
  soup.corners.clear();
  soup.offsets = {0};
  for (const std::vector<VertexIndex>& face : std::vector<std::vector<VertexIndex>>{{0, 2, 3, 1},
                                                                                    {4, 5, 7, 6},
                                                                                    {0, 8, 1, 5, 4},
                                                                                    {2, 6, 7, 3},
                                                                                    {0, 4, 6, 2},
                                                                                    {1, 3, 7, 5},
                                                                                    {0, 1, 8}}) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.close_face();
  }
  const RepairedSurface repaired = repair_surface(soup);
  EXPECT_TRUE(repaired.diagnosis.usable());
  EXPECT_THAT(repaired.repairs, testing::Contains("flipped edges of faces without area: 1"));
  EXPECT_DOUBLE_EQ(volume(repaired.mesh), 1.0);
  EXPECT_DOUBLE_EQ(repaired.diagnosis.area, 6.0);
  EXPECT_EQ(repaired.diagnosis.topology.euler_characteristic, 2);
  EXPECT_EQ(repaired.mesh.points, soup.points);
}

TEST(Surface, NeedlesWithTwoVerticesAtOnePlaceAreDropped) {
  TriangleMesh mesh = triangulate(test::torus(12, 8)).mesh;
  mesh.points[mesh.triangles[5][0]] = mesh.points[mesh.triangles[5][1]];
  const RepairedSurface repaired = repair_surface(soup_of(mesh));
  EXPECT_TRUE(repaired.diagnosis.usable());
  EXPECT_EQ(repaired.diagnosis.topology.faces, 190u);  // without both triangles at the edge
  EXPECT_EQ(repaired.diagnosis.topology.genus, 1);
}

TEST(Surface, EveryReasonIsToldAtOnce) {
  const test::TemporaryFolder folder;
  // A Moebius strip, and a tetrahedron with a fin at an edge.
  const std::filesystem::path path = folder.file("nanocarbon_surface_test.obj",
                                                 "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nv 9 0 0\n"
                                                 "f 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\nf 2 3 5\n"
                                                 "v 20 0 0\nv 21 2 0\nv 22 0 1\nv 23 2 2\nv 24 0 0\n"
                                                 "f 6 7 8\nf 7 8 9\nf 8 9 10\nf 9 10 6\nf 10 6 7\n");
  const std::string message = test::refusal(Failure::unsuitable, [&] { load_surface(path); });
  EXPECT_THAT(message, HasSubstr("nanocarbon_surface_test.obj: the mesh cannot be used:"));
  EXPECT_THAT(
      message,
      HasSubstr("1 edge has more than two faces (at (0, 0, -1), faces 0 and 3 and 4, vertices 1, 2;"));
  EXPECT_THAT(message, HasSubstr("1 piece is not orientable"));
}

TEST(Surface, PointsWithoutFacesAreRefused) {
  PolygonSoup soup;
  soup.points = {Vec3(0, 0, 0), Vec3(1, 0, 0)};
  EXPECT_NE(repair_surface(soup).diagnosis.find(MeshProblem::no_faces), nullptr);
  EXPECT_FALSE(repair_surface(PolygonSoup()).diagnosis.usable());
}

}  // namespace
}  // namespace nanocarbon::mesh
