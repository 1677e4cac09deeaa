// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/solid/unite.h"

#include <gmock/gmock.h>

#include <cmath>

#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/repair/repair_surface.h"
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
