// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/trivalent_network.h"

#include <gmock/gmock.h>

#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/dual.h"
#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon::annealing {
namespace {

std::vector<Vec3> centroids(const TriangleMesh& mesh) {
  std::vector<Vec3> result;
  for (const Triangle& t : mesh.triangles)
    result.push_back((mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3);
  return result;
}

TEST(TrivalentNetwork, IsTheSameDualAsTheMoleculeRooms) {
  const TriangleMesh mesh = structures::icosahedral_triangulation(2, 1);
  const Molecule expected = molecule::dual(mesh);
  const Molecule built = molecule_of(trivalent_network(mesh), centroids(mesh), Space());
  EXPECT_EQ(built.bonds, expected.bonds);
  ASSERT_EQ(built.rings.size(), expected.rings.size());
  for (std::size_t r = 0; r < built.rings.size(); ++r)
    EXPECT_THAT(std::vector(built.rings[r].begin(), built.rings[r].end()),
                testing::UnorderedElementsAreArray(expected.rings[r]));
}

TEST(TrivalentNetwork, AFullereneHasTwelvePentagons) {
  const auto counts = ring_counts(trivalent_network(structures::icosahedral_triangulation(3, 3)));
  ASSERT_EQ(counts.size(), 7u);
  EXPECT_EQ(counts[5], 12u);
  EXPECT_EQ(counts[6], 540u / 2 + 2 - 12);
}

TEST(TrivalentNetwork, TriangulationOfADualIsTheOneItCameFrom) {
  const TriangleMesh mesh = structures::icosahedral_triangulation(2, 0);
  const TriangleMesh back = triangulation_of(trivalent_network(mesh), centroids(mesh), Space());
  EXPECT_EQ(back.triangles, mesh.triangles);
  EXPECT_EQ(back.points.size(), mesh.points.size());
}

// On a flat lattice every atom is the centroid of its triangle, out to the boundary.
TEST(TrivalentNetwork, TriangulationOfAnOpenDualGoesToItsBoundary) {
  TriangleMesh sheet;
  constexpr VertexIndex side = 6;
  for (VertexIndex j = 0; j < side; ++j)
    for (VertexIndex i = 0; i < side; ++i) sheet.points.emplace_back(i + 0.5 * j, std::sqrt(0.75) * j, 0.0);
  for (VertexIndex j = 0; j + 1 < side; ++j)
    for (VertexIndex i = 0; i + 1 < side; ++i) {
      const VertexIndex a = j * side + i;
      sheet.triangles.push_back({a, a + 1, a + side});
      sheet.triangles.push_back({a + 1, a + side + 1, a + side});
    }
  const TriangleMesh back = triangulation_of(trivalent_network(sheet), centroids(sheet), Space());
  EXPECT_EQ(back.triangles, sheet.triangles);
  std::size_t in_place = 0;
  for (std::size_t v = 0; v < sheet.points.size(); ++v)
    in_place += (back.points[v] - sheet.points[v]).norm() < 1e-12;
  // All but the corners, which no triangle of two inner vertices has, and those next to them.
  EXPECT_GE(in_place, sheet.points.size() - 12);
  for (std::size_t v = 0; v < sheet.points.size(); ++v)
    EXPECT_LT((back.points[v] - sheet.points[v]).norm(), 1.0) << v;
}

TEST(TrivalentNetwork, AtomsOnABoundaryLackNeighboursAndBoundaryVerticesAreNoRings) {
  // Six triangles about a vertex: one ring, and six atoms with two bonds each.
  TriangleMesh fan;
  fan.points.resize(7, Vec3::Zero());
  for (VertexIndex k = 0; k < 6; ++k) fan.triangles.push_back({0, 1 + k, 1 + (k + 1) % 6});
  const TrivalentNetwork network = trivalent_network(fan);
  for (const TrivalentAtom& atom : network.atoms)
    EXPECT_EQ(std::count(atom.neighbour.begin(), atom.neighbour.end(), no_atom), 1);
  EXPECT_FALSE(network.rings[0].boundary);
  EXPECT_EQ(network.rings[0].size, 6u);
  for (RingIndex r = 1; r < 7; ++r) {
    EXPECT_TRUE(network.rings[r].boundary);
    std::vector<AtomIndex> chain;
    atoms_of_ring(network, r, chain);
    EXPECT_EQ(chain.size(), 2u);
  }
}

TEST(TrivalentNetwork, ThreeTrianglesAtAnEdgeAreRefused) {
  TriangleMesh mesh;
  mesh.points.resize(5, Vec3::Zero());
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  EXPECT_THROW(trivalent_network(mesh), UserError);
}

}  // namespace
}  // namespace nanocarbon::annealing
