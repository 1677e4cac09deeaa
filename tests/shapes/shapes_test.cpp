// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/shapes/shapes.h"

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <numbers>

#include "nanocarbon/core/error.h"
#include "nanocarbon/shapes/implicit_shapes.h"
#include "shapes/mesh_facts.h"

namespace nanocarbon::shapes {
namespace {

using ::testing::ElementsAre;
using ::testing::Gt;
using ::testing::Pair;
using test::mesh_facts;
using test::MeshFacts;

constexpr double pi = std::numbers::pi;

//! How even a mesh must be. Shapes laid out along loops are better than those out of a lattice, and cuts are
//! worst.
struct Evenness {
  double edge_tolerance;  // relative, of the mean edge
  double smallest_angle;  // degrees
  std::size_t largest_valence;
};
constexpr Evenness lofted = {0.05, 40.0, 7};
constexpr Evenness polygonised = {0.25, 15.0, 12};
constexpr Evenness cut_across = {0.25, 8.0, 12};

//! What every mesh of this project must be to serve as an example: sound, even, and without folds.
void expect_sound(const TriangleMesh& mesh, long euler_characteristic, std::size_t boundaries, double edge,
                  const Evenness& even) {
  const MeshFacts f = mesh_facts(mesh);
  EXPECT_TRUE(f.manifold);
  EXPECT_EQ(f.components, 1u);
  EXPECT_EQ(f.euler_characteristic, euler_characteristic);
  EXPECT_EQ(f.boundaries, boundaries);
  EXPECT_NEAR(f.mean_edge, edge, even.edge_tolerance * edge);
  EXPECT_GT(f.smallest_angle, even.smallest_angle);
  EXPECT_LE(f.largest_valence, even.largest_valence);
  EXPECT_LT(f.sharpest_fold, 45.0);
}

TEST(Shapes, Sphere) {
  const TriangleMesh mesh = make_sphere(2.0, 10);
  EXPECT_EQ(mesh.triangles.size(), 2000u);
  // The icosahedron's edges span 63.43 degrees; blown up, the middles of its faces stretch.
  expect_sound(mesh, 2, 0, 2.0 * 1.107 / 10, {0.10, 50.0, 6});
  EXPECT_NEAR(mesh_facts(mesh).volume, 4.0 / 3.0 * pi * 8.0, 0.3);
}

TEST(Shapes, NestedSpheresAreSpheresAtTheirRadii) {
  const TriangleMesh mesh = make_nested_spheres({.radius = 2.0, .gap = 0.5, .count = 3, .edge = 0.25});
  std::map<long, int> points_at;  // radius in thousandths
  for (const Vec3& p : mesh.points) ++points_at[std::lround(1000 * p.norm())];
  EXPECT_THAT(points_at, ElementsAre(Pair(2000, Gt(300)), Pair(2500, Gt(450)), Pair(3000, Gt(650))));
  const MeshFacts f = mesh_facts(mesh);
  EXPECT_TRUE(f.manifold);
  EXPECT_EQ(f.euler_characteristic, 6);
  EXPECT_EQ(f.boundaries, 0u);
  EXPECT_EQ(f.components, 3u);
  EXPECT_NEAR(f.area, 4.0 * pi * (4.0 + 6.25 + 9.0), 2.0);
  EXPECT_NEAR(f.mean_edge, 0.25, 0.05);
  EXPECT_THROW(make_nested_spheres({.count = 0}), UserError);
  EXPECT_THROW(make_nested_spheres({.gap = 0.0}), UserError);
  EXPECT_THROW(make_nested_spheres({.radius = 100.0, .count = 100, .edge = 0.1}), UserError);
}

TEST(Shapes, Hemisphere) {
  const TriangleMesh mesh = make_hemisphere(1.0, 0.1);
  expect_sound(mesh, 1, 1, 0.1, lofted);
  EXPECT_NEAR(mesh_facts(mesh).area, 2.0 * pi, 0.02);
}

TEST(Shapes, Capsule) {
  const TriangleMesh mesh = make_capsule(1.0, 3.0, 0.15);
  expect_sound(mesh, 2, 0, 0.15, lofted);
  EXPECT_NEAR(mesh_facts(mesh).volume, pi * 3.0 + 4.0 / 3.0 * pi, 0.2);
}

TEST(Shapes, Cylinder) {
  const TriangleMesh mesh = make_cylinder(1.0, 3.0, 0.15);
  expect_sound(mesh, 0, 2, 0.15, lofted);
  EXPECT_NEAR(mesh_facts(mesh).area, 2.0 * pi * 3.0, 0.1);
}

TEST(Shapes, Torus) {
  const TriangleMesh mesh = make_torus(2.0, 0.7, 0.2);
  const MeshFacts f = mesh_facts(mesh);
  EXPECT_TRUE(f.manifold);
  EXPECT_EQ(f.euler_characteristic, 0);
  EXPECT_EQ(f.boundaries, 0u);
  EXPECT_EQ(f.largest_valence, 6u);
  EXPECT_NEAR(f.volume, 2.0 * pi * pi * 2.0 * 0.49, 0.8);
}

TEST(Shapes, HelixClosedAndOpen) {
  HelixShape shape;
  shape.edge = 0.08;
  expect_sound(make_helix(shape), 2, 0, 0.08, lofted);
  const double length = shape.turns * std::hypot(2.0 * pi, 1.0);
  EXPECT_NEAR(mesh_facts(make_helix(shape)).volume, pi * 0.09 * length + 4.0 / 3.0 * pi * 0.027, 0.1);
  shape.open = true;
  expect_sound(make_helix(shape), 0, 2, 0.08, lofted);
}

TEST(Shapes, GenusTwo) {
  const TriangleMesh mesh = make_genus_two(1.0, 0.4, 0.1);
  expect_sound(mesh, -2, 0, 0.1, polygonised);
  EXPECT_GT(mesh_facts(mesh).volume, 2.0 * pi * pi * 0.16);
  EXPECT_LT(mesh_facts(mesh).volume, 4.0 * pi * pi * 0.16);
}

TEST(Shapes, JunctionsOpenAndClosed) {
  for (const auto& [kind, arms] :
       {std::pair(JunctionShape::Kind::y, 3), {JunctionShape::Kind::t, 3}, {JunctionShape::Kind::x, 4}})
    for (const double edge : {0.2, 0.35}) {
      JunctionShape shape;
      shape.kind = kind;
      shape.edge = edge;
      SCOPED_TRACE(testing::Message() << "kind " << static_cast<int>(kind) << ", edge " << edge);
      // A sphere with a hole for each arm.
      expect_sound(make_junction(shape), 2 - arms, static_cast<std::size_t>(arms), edge, polygonised);
      shape.open = false;
      expect_sound(make_junction(shape), 2, 0, edge, polygonised);
    }
}

TEST(Shapes, GyroidComponentIsACutSurface) {
  for (const double cells : {1.0, 1.7}) {
    MinimalSurfacePiece component;
    component.cells = cells;
    SCOPED_TRACE(cells);
    const TriangleMesh mesh = make_minimal_surface_piece(component);
    const MeshFacts f = mesh_facts(mesh);
    expect_sound(mesh, f.euler_characteristic, f.boundaries, component.edge, cut_across);
    EXPECT_GE(f.boundaries, 1u);
    // A gyroid has an area of 3.0915 in the cube of its period.
    EXPECT_NEAR(f.area, 3.0915 * cells * cells * cells, 0.15 * 3.09 * cells * cells * cells);
    for (const Vec3& p : mesh.points) EXPECT_LE(p.cwiseAbs().maxCoeff(), 0.5 * cells + 1e-9);
  }
}

TEST(Shapes, ShellsOfMinimalSurfacesAreClosed) {
  for (const auto kind : {MinimalSurfacePiece::Kind::gyroid, MinimalSurfacePiece::Kind::schwarz_p,
                          MinimalSurfacePiece::Kind::schwarz_d}) {
    MinimalSurfacePiece component;
    component.kind = kind;
    component.thickness = 0.15;
    component.edge = 0.04;
    const MeshFacts f = mesh_facts(make_minimal_surface_piece(component));
    EXPECT_TRUE(f.manifold);
    EXPECT_EQ(f.boundaries, 0u);
    EXPECT_EQ(f.euler_characteristic % 2, 0);
    EXPECT_GT(f.volume, 0.0);
  }
}

TEST(Shapes, RefuseWhatIsNoShape) {
  EXPECT_THROW(make_sphere(-1.0, 3), UserError);
  EXPECT_THROW(make_sphere(1.0, 0), UserError);
  EXPECT_THROW(make_torus(1.0, 1.0, 0.1), UserError);
  EXPECT_THROW(make_capsule(1.0, 2.0, 0.0), UserError);
  EXPECT_THROW(make_genus_two(1.0, 0.9, 0.1), UserError);
  HelixShape helix;
  helix.pitch = 0.1;
  EXPECT_THROW(make_helix(helix), UserError);
  JunctionShape junction;
  junction.arm_length = 1.0;
  EXPECT_THROW(make_junction(junction), UserError);
  MinimalSurfacePiece component;
  component.edge = 1e-6;
  EXPECT_THROW(make_minimal_surface_piece(component), UserError);
}

// Rather than use up the memory, or count past what an integer holds.
TEST(Shapes, RefuseMoreTrianglesThanFit) {
  EXPECT_THROW(make_hemisphere(1.0, 1e-5), UserError);
  EXPECT_THROW(make_capsule(1.0, 1e300, 0.1), UserError);
  EXPECT_THROW(make_cylinder(1.0, 4.0, 1e-5), UserError);
  EXPECT_THROW(make_torus(2.0, 0.8, 1e-5), UserError);
  HelixShape helix;
  helix.turns = 1e12;
  EXPECT_THROW(make_helix(helix), UserError);
  helix = {};
  helix.pitch = 1e300;
  EXPECT_THROW(make_helix(helix), UserError);
}

// A cube so small can miss the surface altogether.
TEST(Shapes, RefuseAComponentTooSmallToHoldTheSurface) {
  for (const double thickness : {0.0, 0.15}) {
    MinimalSurfacePiece component;
    component.thickness = thickness;
    for (const double cells : {1e-300, 0.05, 0.3}) {
      component.cells = cells;
      EXPECT_THROW(make_minimal_surface_piece(component), UserError);
    }
  }
}

}  // namespace
}  // namespace nanocarbon::shapes
