// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/ring_mesh.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "molecule/shapes.h"
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
  // In a cell whose half is shorter than the bonds, every ring counts as crossing its boundary.
  molecule.cell = orthogonal_cell(Vec3(1, 20, 20), {true, false, false});
  EXPECT_TRUE(ring_mesh(molecule).triangles.empty());
}

}  // namespace
}  // namespace nanocarbon::molecule
