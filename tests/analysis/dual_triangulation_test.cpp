// SPDX-License-Identifier: GPL-2.0-or-later
// A molecule's triangulation and back.
#include <gmock/gmock.h>

#include "bonded.h"
#include "nanocarbon/analysis/dual_triangulation.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/molecule/dual.h"
#include "nanocarbon/shapes/shapes.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/schwarzite.h"
#include "nanocarbon/structures/tube.h"

namespace nanocarbon::analysis {
namespace {

// The dual of the triangulation has the molecule's bonds, each atom its triangle.
double expect_same_bonds(const Molecule& molecule) {
  const DualTriangulation found = dual_triangulation(molecule, {});
  const Molecule again = molecule::dual(found.mesh);
  EXPECT_EQ(found.atoms.size(), molecule.size());
  EXPECT_EQ(again.bonds, molecule.bonds);
  EXPECT_TRUE(mesh::mesh_topology(found.mesh).orientable);
  double farthest = 0.0;
  for (std::size_t a = 0; a < again.size(); ++a)
    farthest = std::max(farthest, (again.positions[a] - molecule.positions[found.atoms[a]]).norm());
  return farthest;
}

TEST(DualTriangulation, OfFullerenesIsClosedWithAVertexForEachRing) {
  const Molecule c240 = test::bonded(structures::fullerene(2, 2));
  EXPECT_LT(expect_same_bonds(c240), 0.5);
  const mesh::MeshTopology topology = mesh::mesh_topology(dual_triangulation(c240, {}).mesh);
  EXPECT_EQ(topology.vertices, 122u);  // 12 pentagons and 110 hexagons
  EXPECT_EQ(topology.euler_characteristic, 2);
  EXPECT_EQ(topology.boundary_loops, 0u);
}

TEST(DualTriangulation, OfOpenTubesAndFlakesHasTheirRims) {
  for (const auto& [n, m] : {std::pair{10, 0}, {6, 6}, {7, 3}}) {
    const Molecule tube = test::bonded(structures::open_tube(n, m, 20.0));
    if (test::analysed(tube).bonds.with(1) > 0) continue;  // loose ends have no triangle
    EXPECT_LT(expect_same_bonds(tube), 0.3) << n << ", " << m;
    EXPECT_EQ(mesh::mesh_topology(dual_triangulation(tube, {}).mesh).boundary_loops, 2u);
  }
  // In a plane middles of triangles meet their atoms.
  EXPECT_LT(expect_same_bonds(test::bonded(structures::graphene_flake(12.0))), 1e-3);
}

TEST(DualTriangulation, RunsCounterClockwiseSeenFromOutside) {
  const Molecule c60 = test::bonded(structures::fullerene(1, 1));
  const DualTriangulation found = dual_triangulation(c60, {});
  for (const Triangle& t : found.mesh.triangles) {
    const Vec3 &p = found.mesh.points[t[0]], &q = found.mesh.points[t[1]], &r = found.mesh.points[t[2]];
    EXPECT_GT((q - p).cross(r - p).dot(p), 0.0);
  }
}

TEST(DualTriangulation, OfADualIsTheTriangulation) {
  TriangleMesh torus = shapes::make_torus(20.0, 8.0, 2.46);
  Molecule molecule = molecule::dual(torus);
  const DualTriangulation found = dual_triangulation(molecule, {}, 20);
  EXPECT_EQ(found.mesh.triangles.size(), torus.triangles.size());
  EXPECT_EQ(found.mesh.points.size(), torus.points.size());
  EXPECT_EQ(molecule::dual(found.mesh).bonds, molecule.bonds);
}

using AtomPairs = std::vector<std::pair<AtomIndex, AtomIndex>>;

AtomPairs bonded_pairs(const Molecule& molecule) {
  AtomPairs pairs;
  for (const Bond& bond : molecule.bonds) pairs.emplace_back(std::minmax(bond.first, bond.second));
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// In a cell atoms may come back in another image: pairs are compared, and distances to the nearest image.
mesh::MeshTopology expect_same_bonds_in_cell(const Molecule& molecule) {
  const DualTriangulation found = dual_triangulation(molecule, {});
  const Molecule again = molecule::dual(found.mesh);
  EXPECT_EQ(found.atoms.size(), molecule.size());
  EXPECT_EQ(bonded_pairs(again), bonded_pairs(molecule));
  const Space space(molecule.cell);
  for (std::size_t a = 0; a < again.size(); ++a)
    EXPECT_LT(space.displacement(again.positions[a], molecule.positions[a]).norm(), 0.5) << a;
  return mesh::mesh_topology(found.mesh);
}

TEST(DualTriangulation, OfSheetsTubesAndSchwarzitesGoesThroughTheirCells) {
  const Molecule sheet = test::bonded(structures::graphene(5, 3));
  EXPECT_EQ(expect_same_bonds_in_cell(sheet).euler_characteristic, 0);
  for (const auto& [n, m, periods] : {std::tuple{10, 0, 3}, {6, 6, 4}, {7, 3, 1}}) {
    const mesh::MeshTopology tube =
        expect_same_bonds_in_cell(test::bonded(structures::periodic_tube(n, m, periods)));
    EXPECT_EQ(tube.euler_characteristic, 0) << n << ", " << m;
    EXPECT_EQ(tube.boundary_loops, 0u);
  }
  // Euler characteristic -4 and -2 in a cell (O'Keeffe, Adams and Sankey).
  EXPECT_EQ(
      expect_same_bonds_in_cell(test::bonded(structures::schwarzite_p688(2, 2, 2))).euler_characteristic,
      -4 * 8);
  EXPECT_EQ(
      expect_same_bonds_in_cell(test::bonded(structures::schwarzite_d688(2, 2, 2))).euler_characteristic,
      -2 * 8);
}

std::vector<AtomIndex> loose_atoms(const Molecule& molecule) {
  const BondRows rows = bond_rows(molecule);
  std::vector<AtomIndex> loose;
  for (AtomIndex a = 0; a < molecule.size(); ++a)
    if (rows.degree(a) < 2) loose.push_back(a);
  return loose;
}

TEST(DualTriangulation, OfASheetWithAHoleAcrossItsCellsCornerHasARim) {
  const Molecule sheet = structures::graphene(8, 5);
  const Vec3 corner(sheet.cell->origin.x(), sheet.cell->origin.y(), sheet.positions[0].z());
  std::vector<AtomIndex> removed;
  for (AtomIndex a = 0; a < sheet.size(); ++a)
    if (Space(sheet.cell).displacement(corner, sheet.positions[a]).norm() < 5.0) removed.push_back(a);
  ASSERT_GT(removed.size(), 12u);
  Molecule holed = test::bonded(test::without(sheet, removed));
  for (removed = loose_atoms(holed); !removed.empty(); removed = loose_atoms(holed))
    holed = test::bonded(test::without(holed, removed));
  EXPECT_EQ(expect_same_bonds_in_cell(holed).boundary_loops, 1u);
}

TEST(DualTriangulation, DoesNotDependOnWhereTheCellIsCut) {
  Molecule crystal = structures::schwarzite_p688(2, 2, 2);
  const double area = mesh::area(dual_triangulation(test::bonded(crystal), {}).mesh);
  const Space space(crystal.cell);
  for (Vec3& position : crystal.positions) position = space.wrapped(position + Vec3(3.1, 5.3, 7.7));
  EXPECT_NEAR(mesh::area(dual_triangulation(test::bonded(crystal), {}).mesh), area, 1e-9 * area);
}

TEST(DualTriangulation, RefusesWhatIsNoSurfaceOrHasTooNarrowACell) {
  for (const Molecule& narrow :
       {structures::graphene(1, 1), structures::graphene(2, 3), structures::schwarzite_p688(1, 1, 1)})
    try {
      dual_triangulation(test::bonded(narrow), {});
      ADD_FAILURE() << narrow.size() << " atoms";
    } catch (const UserError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("repeat the cell first"));
    }
  Molecule chain;
  for (int i = 0; i < 5; ++i) chain.positions.push_back(Vec3(1.3 * i, 0, 0));
  chain.elements.assign(5, Element::carbon);
  EXPECT_THROW(dual_triangulation(test::bonded(chain), {}), UserError);
}

}  // namespace
}  // namespace nanocarbon::analysis
