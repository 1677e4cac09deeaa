// SPDX-License-Identifier: GPL-2.0-or-later
// A molecule's triangulation and back.
#include <gmock/gmock.h>

#include "bonded.h"
#include "nanocarbon/analysis/dual_triangulation.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/molecule/dual.h"
#include "nanocarbon/shapes/shapes.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
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

TEST(DualTriangulation, RefusesWhatIsNoSurfaceOrPeriodic) {
  EXPECT_THROW(dual_triangulation(test::bonded(structures::graphene(3, 2)), {}), UserError);
  Molecule chain;
  for (int i = 0; i < 5; ++i) chain.positions.push_back(Vec3(1.3 * i, 0, 0));
  chain.elements.assign(5, Element::carbon);
  EXPECT_THROW(dual_triangulation(test::bonded(chain), {}), UserError);
}

}  // namespace
}  // namespace nanocarbon::analysis
