// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/dual.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <map>

#include "molecule/shapes.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/topology/connected_components.h"

namespace nanocarbon::molecule {
namespace {

std::map<std::size_t, int> ring_sizes(const Molecule& molecule) {
  std::map<std::size_t, int> sizes;
  for (std::size_t r = 0; r < molecule.rings.size(); ++r) ++sizes[molecule.rings[r].size()];
  return sizes;
}

int euler_characteristic(const Molecule& m) {
  return static_cast<int>(m.size()) - static_cast<int>(m.bonds.size()) + static_cast<int>(m.rings.size());
}

TEST(Dual, OfTheIcosahedronIsTheDodecahedronC20) {
  const Molecule molecule = dual(test::icosahedron());
  EXPECT_EQ(molecule.size(), 20u);
  EXPECT_EQ(molecule.bonds.size(), 30u);
  EXPECT_EQ(ring_sizes(molecule), (std::map<std::size_t, int>{{5, 12}}));
}

TEST(Dual, OfSubdividedIcosahedraAreC60AndC540) {
  TriangleMesh mesh = test::sqrt3_subdivided_sphere(test::icosahedron());
  const Molecule c60 = dual(mesh);
  EXPECT_EQ(c60.size(), 60u);
  EXPECT_EQ(c60.bonds.size(), 90u);
  EXPECT_EQ(ring_sizes(c60), (std::map<std::size_t, int>{{5, 12}, {6, 20}}));
  mesh = test::sqrt3_subdivided_sphere(test::sqrt3_subdivided_sphere(mesh));
  const Molecule c540 = dual(mesh);
  EXPECT_EQ(c540.size(), 540u);
  EXPECT_EQ(ring_sizes(c540), (std::map<std::size_t, int>{{5, 12}, {6, 260}}));
  EXPECT_EQ(euler_characteristic(c540), 2);
}

TEST(Dual, AtomsAreTheCentroidsOfTheirTriangles) {
  const TriangleMesh mesh = test::sheet(3, 3);
  const Molecule molecule = dual(mesh);
  ASSERT_EQ(molecule.size(), mesh.triangles.size());
  // The first triangle of the sheet is (0, 0), (1, 0), (1/2, sqrt(3)/2).
  EXPECT_NEAR((molecule.positions[0] - Vec3(0.5, std::sqrt(3.0) / 6.0, 0.0)).norm(), 0.0, 1e-15);
}

TEST(Dual, OfATorusHasEulerCharacteristicZeroAndOnlyHexagons) {
  const Molecule molecule = dual(test::torus(8, 20, 3.0, 1.0));
  EXPECT_EQ(euler_characteristic(molecule), 0);
  EXPECT_EQ(ring_sizes(molecule), (std::map<std::size_t, int>{{6, 160}}));
}

TEST(Dual, RingsOfASphereRunCounterClockwiseSeenFromOutsideAlongBonds) {
  const Molecule molecule = dual(test::sqrt3_subdivided_sphere(test::icosahedron()));
  for (std::size_t r = 0; r < molecule.rings.size(); ++r) {
    const auto ring = molecule.rings[r];
    Vec3 area = Vec3::Zero(), centre = Vec3::Zero();
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const AtomIndex a = ring[k], b = ring[(k + 1) % ring.size()];
      area += molecule.positions[a].cross(molecule.positions[b]);
      centre += molecule.positions[a];
      const Bond bond{std::min(a, b), std::max(a, b), {0, 0, 0}};
      EXPECT_TRUE(std::binary_search(molecule.bonds.begin(), molecule.bonds.end(), bond));
    }
    EXPECT_GT(area.dot(centre), 0.0);
    EXPECT_EQ(ring[0], *std::min_element(ring.begin(), ring.end()));
  }
}

TEST(Dual, OfASheetHasRingsAtInnerVerticesOnly) {
  const Molecule molecule = dual(test::sheet(4, 3));
  EXPECT_EQ(molecule.size(), 24u);
  EXPECT_EQ(ring_sizes(molecule), (std::map<std::size_t, int>{{6, 3 * 2}}));
  // Edges between two triangles: all 3 * 24 / 2 sides less half of the 2 (4 + 3) boundary edges.
  EXPECT_EQ(molecule.bonds.size(), (3u * 24u - 14u) / 2u);
}

TEST(Dual, OfAMoebiusBandHasARingAtEachInnerVertex) {
  // A band of 3 rows of vertices and an odd number of columns, glued with a half twist.
  const int columns = 11;
  TriangleMesh band;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < 3; ++j) band.points.emplace_back(i, j, 0.1 * i * j);
  const auto index = [&](int i, int j) { return static_cast<VertexIndex>(i < columns ? 3 * i + j : 2 - j); };
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < 2; ++j) {
      band.triangles.push_back({index(i, j), index(i + 1, j), index(i, j + 1)});
      band.triangles.push_back({index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  const Molecule molecule = dual(band);
  EXPECT_EQ(molecule.rings.size(), 11u);
  // A Moebius band has Euler characteristic 0; its dual lacks the hexagons that the boundary vertices would
  // be.
  EXPECT_EQ(molecule.bonds.size(), (3u * 44u - 22u) / 2u);
}

TEST(Dual, RefusesWhatIsNoManifold) {
  TriangleMesh three_at_an_edge;
  three_at_an_edge.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, -1, 0)};
  three_at_an_edge.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  EXPECT_THROW(dual(three_at_an_edge), UserError);

  TriangleMesh two_spheres_at_a_vertex = test::icosahedron();
  const TriangleMesh other = test::icosahedron();
  for (const Vec3& p : other.points) two_spheres_at_a_vertex.points.push_back(p + Vec3(5, 0, 0));
  const auto other_index = [](VertexIndex v) { return v == 0 ? 0 : v + 12; };
  for (const Triangle& t : other.triangles)
    two_spheres_at_a_vertex.triangles.push_back({other_index(t[0]), other_index(t[1]), other_index(t[2])});
  EXPECT_THROW(dual(two_spheres_at_a_vertex), UserError);

  TriangleMesh out_of_range = test::icosahedron();
  out_of_range.triangles[3][1] = 12;
  EXPECT_THROW(dual(out_of_range), UserError);
}

TEST(Dual, OfNothingIsNothing) { EXPECT_EQ(dual({}).size(), 0u); }

TEST(ConnectedPieces, AreNumberedByTheirLowestAtom) {
  const std::vector<Bond> bonds = {{1, 4}, {0, 3}, {3, 5}, {4, 6}};
  const topology::Components components = topology::connected_components(8, bonds);
  EXPECT_EQ(components.count, 4u);
  EXPECT_THAT(components.of_atom, testing::ElementsAre(0, 1, 2, 0, 1, 0, 1, 3));
}

}  // namespace
}  // namespace nanocarbon::molecule
