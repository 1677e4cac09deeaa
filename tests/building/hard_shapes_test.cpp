// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nanocarbon/building/build_molecule.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/core/neighbours_within.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/molecule/hydrogens.h"
#include "nanocarbon/shapes/shapes.h"
#include "nanocarbon/topology/connected_components.h"
#include "remeshing/shapes.h"
#include "support/plates.h"

namespace nanocarbon::building {
namespace {

TriangleMesh joined(TriangleMesh one, const TriangleMesh& other, const Vec3& shift) {
  const auto first = static_cast<VertexIndex>(one.points.size());
  for (const Vec3& p : other.points) one.points.push_back(p + shift);
  for (const Triangle& t : other.triangles)
    one.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return one;
}

TriangleMesh inside_out(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
  return mesh;
}

TriangleMesh flattened(TriangleMesh mesh, double factor) {
  for (Vec3& p : mesh.points) p.z() *= factor;
  return mesh;
}

TriangleMesh tetrahedron() {
  return {{Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)},
          {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

// A ball of radius 20 with a finger of radius 3.5 that reaches 30 beyond it.
TriangleMesh ball_with_finger() {
  constexpr double ball = 20, finger = 3.5, length = 30;
  TriangleMesh mesh = shapes::make_sphere(1, 48);
  const double neck = std::asin(finger / ball), foot = ball * std::cos(neck);
  // The ball's surface is drawn from the upper tenth of the sphere's half turn on; that tenth is the finger.
  constexpr double share = 0.1 * std::numbers::pi;
  const double cap = 0.5 * std::numbers::pi * finger;
  for (Vec3& p : mesh.points) {
    const double turn = std::acos(std::clamp(p.z(), -1.0, 1.0)), round = std::atan2(p.y(), p.x());
    double out = 0, up = 0;
    if (turn < share) {
      const double along = turn / share * (cap + length);
      out = along < cap ? finger * std::sin(along / finger) : finger;
      up = along < cap ? foot + length + finger * std::cos(along / finger) : foot + length - (along - cap);
    } else {
      const double angle = neck + (turn - share) / (std::numbers::pi - share) * (std::numbers::pi - neck);
      out = ball * std::sin(angle);
      up = ball * std::cos(angle);
    }
    p = Vec3(out * std::cos(round), out * std::sin(round), up);
  }
  return mesh;
}

// The promises of the default recipe, seen from outside.
void expect_molecule_that_holds(const TriangleMesh& surface, std::size_t atoms, bool force = false) {
  BuildOptions options;
  options.force = force;
  options.size = AtomCount{atoms};
  options.quality = Quality::draft;
  const BuildResult result = build_molecule(surface, options);
  const Molecule molecule = molecule::carbon_skeleton(result.molecule);
  EXPECT_TRUE(result.rest->intact);
  EXPECT_NEAR(static_cast<double>(molecule.size()), static_cast<double>(atoms),
              std::max(0.01 * static_cast<double>(atoms), 4.0));
  const mesh::MeshTopology topology = mesh::mesh_topology(surface);
  EXPECT_EQ(topology::connected_components(molecule.size(), molecule.bonds).count, topology.components);
  // What REBO2 will see: the bonds and nothing else between 1.7 and 2.0 Angstrom.
  const NeighbourList near = neighbours_within(molecule.positions, nullptr, 2.0);
  EXPECT_EQ(near.neighbours.size(), 2 * molecule.bonds.size());
  for (const Bond& bond : molecule.bonds)
    EXPECT_LT((molecule.positions[bond.first] - molecule.positions[bond.second]).norm(), 1.7);
  for (std::size_t r = 0; r < molecule.rings.size(); ++r) {
    EXPECT_GE(molecule.rings[r].size(), 5u);
    EXPECT_LE(molecule.rings[r].size(), 7u);
  }
  if (topology.boundary_loops > 0) return;
  EXPECT_EQ(2 * molecule.bonds.size(), 3 * molecule.size());
  EXPECT_EQ(static_cast<std::int64_t>(molecule.size() + molecule.rings.size()) -
                static_cast<std::int64_t>(molecule.bonds.size()),
            topology.euler_characteristic);
}

TEST(HardShapes, SmallCages) {
  for (const std::size_t atoms : {60u, 80u, 120u})
    expect_molecule_that_holds(shapes::make_sphere(1, 8), atoms);
}

TEST(HardShapes, SharpEdgesAndCorners) {
  expect_molecule_that_holds(tetrahedron(), 300);
  expect_molecule_that_holds(test::icosahedron(1), 300);
}

// 7 Angstrom thick in the middle, with a rim narrower than any tube.
TEST(HardShapes, ALensWithASharpRim) {
  expect_molecule_that_holds(flattened(shapes::make_sphere(1, 10), 0.2), 800);
}

// Sheets 2.5 Angstrom apart: refused, but with --force the molecule makes the room it needs.
TEST(HardShapes, APlateThinnerThanTwoSheets) { expect_molecule_that_holds(test::pill(14, 2.5), 608, true); }

// At a quarter of the atoms the finger is thinner than any tube: what is refined from there must not have
// lost it. Its end cap may round off.
TEST(HardShapes, AThinFingerKeepsItsLength) {
  const TriangleMesh surface = ball_with_finger();
  BuildOptions options;
  options.size = AtomCount{2180};
  options.threads = 2;
  const BuildResult result = build_molecule(surface, options);
  EXPECT_TRUE(result.rest->intact);
  const Vec3 tip = surface.points[static_cast<std::size_t>(
      std::max_element(surface.points.begin(), surface.points.end(),
                       [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); }) -
      surface.points.begin())];
  double nearest = 1e9;
  for (const Vec3& p : result.molecule.positions)
    nearest = std::min(nearest, (p - result.surface.scale * tip).norm());
  EXPECT_LT(nearest, 10);  // of 33.5
}

TEST(HardShapes, PiecesBesideAndWithinEachOther) {
  expect_molecule_that_holds(
      joined(shapes::make_sphere(1, 8), shapes::make_torus(2, 0.8, 0.2), Vec3(6, 0, 0)), 1200);
  expect_molecule_that_holds(
      joined(shapes::make_sphere(1, 8), inside_out(shapes::make_sphere(0.6, 6)), Vec3::Zero()), 1500);
}

TEST(HardShapes, OpenSurfaces) {
  expect_molecule_that_holds(shapes::make_hemisphere(1, 0.1), 300);
  expect_molecule_that_holds(shapes::make_cylinder(1, 4, 0.2), 500);
}

}  // namespace
}  // namespace nanocarbon::building
