// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/ring_mesh.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "molecule/shapes.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/molecule/dual.h"

namespace nanocarbon::molecule {
namespace {

double area(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += 0.5 * (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).norm();
  return sum;
}

double volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += mesh.points[a].dot(mesh.points[b].cross(mesh.points[c])) / 6.0;
  return sum;
}

TEST(RingMesh, OfC60EnclosesTheTruncatedIcosahedron) {
  const Molecule c60 = dual(test::sqrt3_subdivided_sphere(test::icosahedron()));
  const TriangleMesh mesh = ring_mesh(c60);
  EXPECT_EQ(mesh.points.size(), 92u);
  EXPECT_EQ(mesh.triangles.size(), 180u);
  double radius = 0.0;
  for (const Vec3& p : c60.positions) radius += p.norm() / 60.0;
  // A truncated icosahedron fills 0.867 of its circumsphere, with bonds of one length; ours have nearly one.
  EXPECT_NEAR(volume(mesh) / (4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3)), 0.867, 0.02);
}

TEST(RingMesh, CoversAFlatSheetsRings) {
  Molecule molecule = dual(test::sheet(4, 3));
  const double hexagon = 3.0 * std::sqrt(3.0) / 2.0 / 3.0;  // of side 1 / sqrt(3)
  EXPECT_NEAR(area(ring_mesh(molecule)), 6.0 * hexagon, 1e-12);
}

TEST(RingMesh, ARingThatReachesAcrossACellsBoundaryIsWhole) {
  Molecule molecule;
  molecule.cell = orthogonal_cell(Vec3(10, 20, 20), {true, false, false});
  for (int k = 0; k < 6; ++k) {
    const double angle = k * std::numbers::pi / 3;
    molecule.positions.emplace_back(std::fmod(10 + std::cos(angle), 10), std::sin(angle), 0);
    molecule.rings.atoms.push_back(static_cast<AtomIndex>(k));
  }
  molecule.rings.offsets.push_back(6);
  EXPECT_NEAR(mesh::area(ring_mesh(molecule)), 1.5 * std::sqrt(3.0), 1e-12);
}

}  // namespace
}  // namespace nanocarbon::molecule
