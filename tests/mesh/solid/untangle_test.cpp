// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/solid/untangle.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/repair/repair_surface.h"
#include "nanocarbon/mesh/self_intersections.h"
#include "nanocarbon/mesh/solid/advice.h"
#include "nanocarbon/mesh/triangulate.h"
#include "nanocarbon/shapes/shapes.h"
#include "support/closed_surface.h"
#include "support/small_meshes.h"

namespace nanocarbon::mesh {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

VertexIndex nearest_vertex(const TriangleMesh& mesh, const Vec3& to) {
  VertexIndex nearest = 0;
  for (VertexIndex v = 0; v < mesh.points.size(); ++v)
    if ((mesh.points[v] - to).norm() < (mesh.points[nearest] - to).norm()) nearest = v;
  return nearest;
}

TriangleMesh moved_vertex(TriangleMesh mesh, const Vec3& from, const Vec3& to) {
  mesh.points[nearest_vertex(mesh, from)] = to;
  return mesh;
}

//! A ball with a vertex pulled through to the outside on the other side.
TriangleMesh pierced_ball() {
  return moved_vertex(shapes::make_sphere(1.0, 16), Vec3(0, 0, 1), Vec3(0.01, 0.02, -1.3));
}

//! A ball with two spikes that cross each other above it.
TriangleMesh ball_with_crossing_spikes() {
  const TriangleMesh ball = shapes::make_sphere(1.0, 16);
  return moved_vertex(moved_vertex(ball, Vec3(0.35, 0, 0.94), Vec3(-0.3, 0.01, 1.6)), Vec3(-0.35, 0, 0.94),
                      Vec3(0.3, -0.01, 1.6));
}

//! A ball with two neighbours that have changed places, so that the surface is folded twice over between them.
TriangleMesh folded_ball() {
  TriangleMesh ball = shapes::make_sphere(1.0, 16);
  std::swap(ball.points[nearest_vertex(ball, Vec3(0, 0, 1))],
            ball.points[nearest_vertex(ball, Vec3(0.1, 0, 0.995))]);
  return ball;
}

void expect_mended(const TriangleMesh& mesh) {
  ASSERT_THAT(self_intersections(mesh).pairs, Not(IsEmpty()));
  const Untangled untangled = untangle(mesh);
  EXPECT_EQ(untangled.components, 1u);
  EXPECT_GT(untangled.crossings, 0u);
  EXPECT_THAT(self_intersections(untangled.mesh).pairs, IsEmpty());
  const MeshTopology surface = test::closed_surface(untangled.mesh);
  EXPECT_EQ(surface.components, 1u);
  EXPECT_EQ(surface.genus, 0);
  const double ball = signed_volume(shapes::make_sphere(1.0, 16));
  EXPECT_NEAR(signed_volume(untangled.mesh), ball, 0.03 * ball);
  EXPECT_LT(untangled.to_original, 0.1);
  EXPECT_LT(untangled.replaced, mesh.triangles.size() / 10);
  EXPECT_EQ(untangle(mesh).mesh.points, untangled.mesh.points) << "not the same each time";
  EXPECT_EQ(untangle(mesh).mesh.triangles, untangled.mesh.triangles);
  const auto advice = advise(soup_of(mesh));
  ASSERT_TRUE(advice);
  EXPECT_EQ(advice->options, "--untangle");
}

TEST(Untangle, AVertexThatWasPushedThroughTheOtherSide) { expect_mended(pierced_ball()); }

// Of large triangles: the cap that is put where the vertex was lies an edge away from what is left, which is more than a
// twentieth of the ball.
TEST(Untangle, AVertexThatWasPushedThroughTheOtherSideOfACoarseBall) {
  const TriangleMesh coarse = shapes::make_sphere(1.0, 5);
  const TriangleMesh pierced = moved_vertex(coarse, Vec3(0, 0, 1), Vec3(0.01, 0.02, -1.3));
  const double twentieth = 0.05 * bounding_box(pierced.points).diagonal();
  const Untangled untangled = untangle(pierced);
  EXPECT_GT(untangled.to_original, twentieth);
  EXPECT_LT(untangled.to_original, edge_lengths(coarse).max * 1.5);
  EXPECT_THAT(self_intersections(untangled.mesh).pairs, IsEmpty());
  EXPECT_NEAR(signed_volume(untangled.mesh), signed_volume(coarse), 0.1 * signed_volume(coarse));
}

TEST(Untangle, SpikesThatCross) { expect_mended(ball_with_crossing_spikes()); }

TEST(Untangle, AFold) { expect_mended(folded_ball()); }

// What is elsewhere, and pieces beside and within, stay as they are, in place and order.
TEST(Untangle, NothingElseChanges) {
  const TriangleMesh inner = shapes::make_sphere(0.3, 4);
  const Untangled untangled = untangle(test::together(inner, folded_ball()));
  EXPECT_EQ(untangled.components, 1u);
  EXPECT_TRUE(std::equal(inner.points.begin(), inner.points.end(), untangled.mesh.points.begin()));
  EXPECT_TRUE(std::equal(inner.triangles.begin(), inner.triangles.end(), untangled.mesh.triangles.begin()));

  const Untangled sound = untangle(inner);
  EXPECT_EQ(sound.mesh.points, inner.points);
  EXPECT_EQ(sound.mesh.triangles, inner.triangles);
  EXPECT_EQ(describe(sound), "untangled nothing: no piece crosses itself");
}

using Corners = std::array<std::array<double, 3>, 3>;

std::set<Corners> faces_of(const TriangleMesh& mesh) {
  std::set<Corners> faces;
  for (const Triangle& t : mesh.triangles) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = {mesh.points[t[k]].x(), mesh.points[t[k]].y(), mesh.points[t[k]].z()};
    std::sort(corners.begin(), corners.end());
    faces.insert(corners);
  }
  return faces;
}

// Faults in two places, which are mended in their surroundings alone: whatever is not told as replaced is still there.
TEST(Untangle, WhatIsNotReplacedStays) {
  TriangleMesh ball = shapes::make_sphere(1.0, 40);
  for (const Vec3& at : {Vec3(0, 0, 1), Vec3(1, 0, 0)})
    std::swap(ball.points[nearest_vertex(ball, at)],
              ball.points[nearest_vertex(ball, (at + Vec3(0.03, 0.03, 0.02)).normalized())]);
  const Untangled untangled = untangle(ball);
  EXPECT_GT(untangled.crossings, 0u);
  EXPECT_THAT(self_intersections(untangled.mesh).pairs, IsEmpty());
  EXPECT_EQ(test::closed_surface(untangled.mesh).genus, 0);
  const std::set<Corners> before = faces_of(ball), after = faces_of(untangled.mesh);
  std::size_t kept = 0;
  for (const Corners& face : before) kept += after.count(face);
  EXPECT_EQ(kept, before.size() - untangled.replaced);
  EXPECT_LT(untangled.replaced, before.size() / 100);
}

// Boundaries stay open.
TEST(Untangle, AnOpenSurfaceStaysOpen) {
  TriangleMesh bowl = folded_ball();
  std::erase_if(bowl.triangles, [&](const Triangle& t) { return bowl.points[t[0]].z() < -0.5; });
  const Untangled untangled = untangle(bowl);
  EXPECT_THAT(self_intersections(untangled.mesh).pairs, IsEmpty());
  EXPECT_EQ(mesh_topology(untangled.mesh).boundary_loops, 1u);
  EXPECT_EQ(mesh_topology(untangled.mesh).euler_characteristic, 1);
}

std::string refusal(const TriangleMesh& mesh) {
  try {
    untangle(mesh);
  } catch (const UserError& error) {
    EXPECT_EQ(error.failure(), Failure::unsuitable);
    return error.what();
  }
  return "none";
}

// A ring whose hole is less than nothing is no small fault.
TEST(Untangle, RefusesSurfacesThatPassThroughThemselvesAndSaysWhere) {
  const TriangleMesh spindle = triangulate(test::torus(24, 16, 0.2, 0.3)).mesh;
  EXPECT_THAT(refusal(spindle), testing::AllOf(HasSubstr("of faces of a piece intersect, first at ("),
                                               HasSubstr("--wrap SIZE")));
  EXPECT_FALSE(advise(soup_of(spindle)));
  const TriangleMesh fine = triangulate(test::torus(96, 64, 0.2, 0.3)).mesh;
  EXPECT_THAT(refusal(fine), HasSubstr("so many are no small fault"));
}

// Two overlapping solids of which one crosses itself.
TEST(Untangle, AUnionMayNeedItFirst) {
  TriangleMesh other = shapes::make_sphere(1.0, 16);
  for (Vec3& p : other.points) p += Vec3(1.2, 0.01, 0.02);
  const auto advice = advise(soup_of(test::together(folded_ball(), other)));
  ASSERT_TRUE(advice);
  EXPECT_EQ(advice->options, "--untangle --unite");
}

// The faces of a cavity look inwards: a piece of negative volume.
TEST(Untangle, ACavityStaysOne) {
  TriangleMesh cavity = folded_ball();
  for (Triangle& t : cavity.triangles) std::swap(t[1], t[2]);
  const Untangled untangled = untangle(cavity);
  EXPECT_EQ(untangled.components, 1u);
  const double ball = signed_volume(shapes::make_sphere(1.0, 16));
  EXPECT_NEAR(signed_volume(untangled.mesh), -ball, 0.03 * ball);
}

}  // namespace
}  // namespace nanocarbon::mesh
