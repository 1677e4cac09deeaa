// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/solid/unite.h"

#include <gmock/gmock.h>

#include <cmath>
#include <utility>

#include "nanocarbon/mesh/join_points.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/repair/repair_surface.h"
#include "nanocarbon/mesh/solid/repair_solids.h"
#include "nanocarbon/mesh/triangulate.h"
#include "nanocarbon/shapes/shapes.h"
#include "support/closed_surface.h"
#include "support/refusal.h"
#include "support/small_meshes.h"

namespace nanocarbon::mesh {
namespace {

using testing::HasSubstr;

TriangleMesh moved(TriangleMesh mesh, const Vec3& by) {
  for (Vec3& point : mesh.points) point += by;
  return mesh;
}

TriangleMesh cube(const Vec3& at, double edge = 1.0) { return triangulate(test::cube(at, edge)).mesh; }

TriangleMesh box(const Vec3& low, const Vec3& high) {
  TriangleMesh mesh = cube(Vec3::Zero());
  for (Vec3& p : mesh.points) p = low + p.cwiseProduct(high - low);
  return mesh;
}

TEST(Unite, TwoSpheresBecomeTheBodyThatTheyFill) {
  const TriangleMesh sphere = shapes::make_sphere(1.0, 16);
  const double lens = M_PI * (4.0 + 1.2) * std::pow(2.0 - 1.2, 2) / 12.0;  // of unit spheres 1.2 apart
  const United united = unite(test::together(sphere, moved(sphere, {1.2, 0.013, 0.007})));
  const MeshTopology topology = test::closed_surface(united.mesh);
  EXPECT_EQ(united.overlapping, 2u);
  EXPECT_EQ(united.unions, 1u);
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.genus, 0);
  EXPECT_NEAR(signed_volume(united.mesh), 2.0 * signed_volume(sphere) - lens, 0.02);
}

TEST(Unite, FacesThatLieInOnePlaneAreNoObstacle) {
  const United united = unite(test::together(cube({0, 0, 0}), cube({0.5, 0, 0})));
  EXPECT_EQ(test::closed_surface(united.mesh).genus, 0);
  EXPECT_NEAR(signed_volume(united.mesh), 1.5, 1e-12);
}

// Four beams that overlap at the corners of a frame.
TEST(Unite, AFrameHasAHole) {
  TriangleMesh beams = box({0, 0, 0}, {4, 1, 1});
  for (const TriangleMesh& beam : {box({0, 3, 0.1}, {4, 4, 0.9}), box({0.1, 0.1, 0.2}, {0.9, 3.9, 0.8}),
                                   box({3.1, 0.1, 0.3}, {3.9, 3.9, 0.7})})
    beams = test::together(beams, beam);
  const United united = unite(beams);
  EXPECT_EQ(united.overlapping, 4u);
  const MeshTopology topology = test::closed_surface(united.mesh);
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.genus, 1);
  const double outer = 4.0 + 4.0 * 0.8, between = 2.0;  // along y, from one beam to the other
  EXPECT_NEAR(signed_volume(united.mesh), outer + between * 0.8 * (0.6 + 0.4), 1e-9);
}

TEST(Unite, WhatOverlapsNothingStaysAsItIs) {
  const TriangleMesh far = cube({5, 5, 5}), inner = cube({5.4, 5.4, 5.4}, 0.2);
  const United nothing = unite(test::together(far, inner));
  EXPECT_EQ(nothing.overlapping, 0u);
  EXPECT_EQ(nothing.mesh.triangles.size(), 24u);
  EXPECT_THAT(describe(nothing), HasSubstr("no pieces overlap"));
  const United united = unite(
      test::together(test::together(far, inner), test::together(cube({0, 0, 0}), cube({0.5, 0.4, 0.3}))));
  EXPECT_EQ(mesh_topology(united.mesh).components, 3u);
  EXPECT_NEAR(signed_volume(united.mesh), 1.0 + 0.008 + 2.0 - 0.5 * 0.6 * 0.7, 1e-12);
}

TEST(Unite, APieceWoundInsideOutIsASolidAllTheSame) {
  const United united = unite(test::together(cube({0, 0, 0}), test::turned(cube({0.5, 0.4, 0.3}))));
  EXPECT_NEAR(signed_volume(united.mesh), 2.0 - 0.5 * 0.6 * 0.7, 1e-12);
}

//! A cube whose faces are cut into squares.
PolygonSoup fine_cube(const Vec3& at, int squares) {
  PolygonSoup soup;
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {0, 1})
      for (int i = 0; i < squares; ++i)
        for (int j = 0; j < squares; ++j) {
          const auto corner = [&](int u, int v) {
            Vec3 p;
            p[axis] = side;
            p[(axis + 1) % 3] = double(i + u) / squares;
            p[(axis + 2) % 3] = double(j + v) / squares;
            soup.corners.push_back(static_cast<VertexIndex>(soup.points.size()));
            soup.points.push_back(at + p);
          };
          if (side == 1)
            for (const auto& [u, v] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) corner(u, v);
          else
            for (const auto& [u, v] : {std::pair(0, 0), {0, 1}, {1, 1}, {1, 0}}) corner(u, v);
          soup.close_face();
        }
  join(soup, coincident_points(soup.points));
  return soup;
}

PolygonSoup together(const PolygonSoup& one, const PolygonSoup& other) {
  PolygonSoup soup = one;
  for (std::size_t face = 0; face < other.faces(); ++face) {
    for (const VertexIndex v : other.face(face))
      soup.corners.push_back(v + static_cast<VertexIndex>(one.points.size()));
    soup.close_face();
  }
  soup.points.insert(soup.points.end(), other.points.begin(), other.points.end());
  return soup;
}

//! Each face with points of its own, as in STL files.
PolygonSoup apart(const PolygonSoup& soup) {
  PolygonSoup faces;
  for (std::size_t face = 0; face < soup.faces(); ++face) {
    for (const VertexIndex v : soup.face(face)) {
      faces.corners.push_back(static_cast<VertexIndex>(faces.points.size()));
      faces.points.push_back(soup.points[v]);
    }
    faces.close_face();
  }
  return faces;
}

void expect_union(const PolygonSoup& soup, double volume, const char* what) {
  SCOPED_TRACE(what);
  const RepairedSolids solids = repair_solids(soup);
  ASSERT_TRUE(solids.manifold);
  const United united = unite(solids.mesh);
  EXPECT_EQ(united.overlapping, 2u);
  const MeshTopology topology = test::closed_surface(united.mesh);
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.genus, 0);
  EXPECT_NEAR(signed_volume(united.mesh), volume, 1e-9);
}

// Cubes on one grid, so that they cross along edges of both, and there is no place where an edge of one goes through
// a face of the other.
TEST(Unite, SolidsThatShareTheEdgesAlongWhichTheyCross) {
  const PolygonSoup cubes = together(fine_cube({0, 0, 0}, 2), fine_cube({0.5, 0.5, 0.5}, 2));
  PolygonSoup joined = cubes;
  join(joined, coincident_points(joined.points));
  expect_union(cubes, 2 - 0.125, "in pieces");
  expect_union(joined, 2 - 0.125, "with common vertices");
  expect_union(apart(cubes), 2 - 0.125, "face by face");
}

// In one row: they have faces in common that are one face once all is joined.
TEST(Unite, SolidsThatShareFaces) {
  const PolygonSoup cubes = together(fine_cube({0, 0, 0}, 2), fine_cube({0.5, 0, 0}, 2));
  expect_union(cubes, 1.5, "in pieces");
  expect_union(apart(cubes), 1.5, "face by face");
}

// Vertices at the same places alone make no crossing.
TEST(Unite, SolidsThatTouchAtVerticesAndEdgesStay) {
  for (const Vec3& at : {Vec3(1, 1, 0), Vec3(1, 1, 1)}) {
    const RepairedSolids solids = repair_solids(together(fine_cube({0, 0, 0}, 2), fine_cube(at, 2)));
    ASSERT_TRUE(solids.manifold);
    EXPECT_EQ(unite(solids.mesh).overlapping, 0u);
  }
}

TEST(Unite, RefusesWhatIsNoSolidAndSaysWhere) {
  TriangleMesh open = cube({0.5, 0.4, 0.3});
  open.triangles.pop_back();
  const auto reason = [](const TriangleMesh& mesh) {
    return test::refusal(Failure::unsuitable, [&] { unite(mesh); });
  };
  const std::string not_closed = reason(test::together(cube({0, 0, 0}), open));
  EXPECT_THAT(not_closed, HasSubstr("not closed"));
  EXPECT_THAT(not_closed, HasSubstr("(0.5, 0.4, 0.3)"));
  EXPECT_THAT(not_closed, HasSubstr("--wrap"));
  const TriangleMesh spindle = triangulate(test::torus(30, 20, 1.0, 1.5)).mesh;
  EXPECT_THAT(reason(test::together(spindle, cube({2, 0, 0}))), HasSubstr("crosses itself"));
  EXPECT_THAT(reason(test::together(cube({0, 0, 0}), cube({1, 1, 0.3}))), HasSubstr("not a 2-manifold"));
}

}  // namespace
}  // namespace nanocarbon::mesh
