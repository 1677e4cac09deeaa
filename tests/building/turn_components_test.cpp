// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/turn_components.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "nanocarbon/mesh/nearest_point.h"
#include "nanocarbon/shapes/shapes.h"
#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon::building {
namespace {

void append(Molecule& to, const Molecule& more) {
  const auto offset = static_cast<AtomIndex>(to.size());
  to.positions.insert(to.positions.end(), more.positions.begin(), more.positions.end());
  to.elements.insert(to.elements.end(), more.elements.begin(), more.elements.end());
  for (const Bond& b : more.bonds) to.bonds.push_back({b.first + offset, b.second + offset});
}

topology::Components components_of(const Molecule& m) {
  return topology::connected_components(m.size(), m.bonds);
}

double radius_of(const Molecule& m) {
  double sum = 0;
  for (const Vec3& p : m.positions) sum += p.norm();
  return sum / static_cast<double>(m.size());
}

// C60 in C240: a known onion. Turned by any angle, the inner shell finds a place as good as the aligned one.
TEST(TurnComponents, ShellsFindWhereTheyFit) {
  const Molecule c60 = structures::fullerene(1, 1), c240 = structures::fullerene(2, 2);
  Molecule onion = c240;
  append(onion, c60);
  const TriangleMesh surface = shapes::make_nested_spheres(
      {.radius = radius_of(c60), .gap = radius_of(c240) - radius_of(c60), .count = 2, .edge = 0.5});
  const double aligned = turn_components(onion.positions, components_of(onion), surface, 1).after;
  const Mat3 askew = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  Molecule turned = c240;
  append(turned, c60);
  for (std::size_t a = c240.size(); a < turned.size(); ++a) turned.positions[a] = askew * turned.positions[a];
  const auto before = turned.positions;
  const TurnedComponents result = turn_components(turned.positions, components_of(turned), surface, 1);
  EXPECT_LE(result.after, result.before);
  EXPECT_NEAR(result.after, aligned, 0.01 * std::abs(aligned));
  // Rigidly, and the larger one not at all.
  for (std::size_t a = 0; a < c240.size(); ++a) EXPECT_EQ(turned.positions[a], before[a]);
  for (std::size_t a = c240.size() + 1; a < turned.size(); ++a)
    EXPECT_NEAR((turned.positions[a] - turned.positions[a - 1]).norm(), (before[a] - before[a - 1]).norm(),
                1e-10);
}

// C60 beside C240, with an atom alone in a hollow on its other side: that cannot follow when C60 is turned.
TEST(TurnComponents, NeverEndsAboveWhereItBegan) {
  const Molecule c60 = structures::fullerene(1, 1), c240 = structures::fullerene(2, 2);
  const Vec3 beside(radius_of(c240) + radius_of(c60) + 3.6, 0, 0);
  Molecule molecule = c240, turned = c60, alone;
  const Mat3 askew = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (Vec3& p : turned.positions) p = askew * p + beside;
  append(molecule, turned);
  // As far as can be from all atoms of C60, on a sphere around it.
  double farthest = 0;
  Vec3 hollow = Vec3::Zero();
  for (int k = 0; k < 2000; ++k) {
    const double x = (k + 0.5) / 2000, angle = 2.399963 * k;  // the golden angle
    const Vec3 way(x, std::sqrt(1 - x * x) * std::cos(angle), std::sqrt(1 - x * x) * std::sin(angle));
    const Vec3 p = beside + (radius_of(c60) + 2.75) * way;
    double nearest = 1e9;
    for (const Vec3& q : turned.positions) nearest = std::min(nearest, (p - q).norm());
    if (nearest > farthest) {
      farthest = nearest;
      hollow = p;
    }
  }
  alone.positions = {hollow};
  alone.elements = {Element::carbon};
  append(molecule, alone);
  TriangleMesh surface = shapes::make_sphere(radius_of(c240), 10);
  for (const Triangle& t : shapes::make_sphere(1, 10).triangles)
    surface.triangles.push_back({t[0] + static_cast<VertexIndex>(surface.points.size()),
                                 t[1] + static_cast<VertexIndex>(surface.points.size()),
                                 t[2] + static_cast<VertexIndex>(surface.points.size())});
  for (const Vec3& p : shapes::make_sphere(radius_of(c60), 10).points) surface.points.push_back(p + beside);
  const auto corner = static_cast<VertexIndex>(surface.points.size());
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(0.1, 0, 0), Vec3(0, 0.1, 0)})
    surface.points.push_back(hollow + p);
  surface.triangles.push_back({corner, corner + 1, corner + 2});

  const auto before = molecule.positions;
  const TurnedComponents result = turn_components(molecule.positions, components_of(molecule), surface, 1);
  EXPECT_LT(result.before, 0);
  EXPECT_LE(result.after, result.before);
  if (result.turned == 0) {
    EXPECT_EQ(molecule.positions, before);
  }
}

// An ellipsoid in another one, its axes all different, can only be turned by little or by half a turn.
TEST(TurnComponents, NoneLeavesItsSurface) {
  TriangleMesh surface;
  Molecule molecule;
  const TriangleMesh sphere = shapes::make_sphere(1, 6);
  for (const double size : {1.0, 0.5}) {
    const auto offset = static_cast<VertexIndex>(surface.points.size());
    for (const Vec3& p : sphere.points) surface.points.push_back(size * p.cwiseProduct(Vec3(12, 7.5, 6)));
    for (const auto& [a, b, c] : sphere.triangles) {
      surface.triangles.push_back({a + offset, b + offset, c + offset});
      molecule.bonds.push_back({std::min(a, b) + offset, std::max(a, b) + offset});
    }
  }
  molecule.positions = surface.points;
  molecule.elements.assign(surface.points.size(), Element::carbon);
  const topology::Components components = components_of(molecule);
  ASSERT_EQ(components.count, 2u);
  const TurnedComponents result = turn_components(molecule.positions, components, surface, 1);
  EXPECT_LE(result.after, result.before);
  const mesh::NearestPoint nearest(surface);
  for (const Vec3& p : molecule.positions) EXPECT_LT(nearest.nearest(p).distance, 0.2);
}

TEST(TurnComponents, OneAloneOrFarAwayStays) {
  Molecule molecule = structures::fullerene(1, 1);
  const auto surface =
      shapes::make_nested_spheres({.radius = radius_of(molecule), .gap = 3, .count = 1, .edge = 0.5});
  EXPECT_EQ(turn_components(molecule.positions, components_of(molecule), surface, 1).turned, 0u);
  Molecule far = structures::fullerene(1, 1);
  for (Vec3& p : far.positions) p += Vec3(20, 0, 0);
  append(molecule, far);
  const auto before = molecule.positions;
  EXPECT_EQ(turn_components(molecule.positions, components_of(molecule), surface, 1).turned, 0u);
  EXPECT_EQ(molecule.positions, before);
}

}  // namespace
}  // namespace nanocarbon::building
