// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/dual_relaxation.h"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "nanocarbon/annealing/spring_relaxation.h"
#include "nanocarbon/annealing/trivalent_network.h"
#include "nanocarbon/molecule/dual.h"
#include "remeshing/shapes.h"
#include "support/rough_sphere.h"

namespace nanocarbon::annealing {
namespace {

constexpr double sphere_area = 4 * std::numbers::pi;

Molecule scaled_dual(TriangleMesh mesh, double scale) {
  for (Vec3& p : mesh.points) p *= scale;
  return molecule::dual(mesh);
}

TEST(RelaxDual, BringsARoughTriangulationsBondsIntoTheWindow) {
  const TriangleMesh rough = test::rough_sphere(6, 1, 0.2, 0.3);
  const double scale = test::scale_for(rough.triangles.size(), sphere_area);
  Molecule molecule = scaled_dual(rough, scale);
  const std::vector<Bond> bonds = molecule.bonds;
  double shortest = 10, longest = 0;
  for (const Bond& bond : bonds) {
    const double length = (molecule.positions[bond.first] - molecule.positions[bond.second]).norm();
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
  }
  ASSERT_LT(shortest, 1.0) << "the start is meant to be bad";
  ASSERT_GT(longest, 2.0);

  const TetherSurface surface(test::unit_sphere(20), scale);
  const DualRelaxationResult result = relax_dual(molecule, surface);
  EXPECT_EQ(molecule.bonds, bonds);
  EXPECT_GT(result.shortest_bond, 1.2);
  EXPECT_LT(result.longest_bond, 1.7);
  EXPECT_GT(result.closest_unbonded, 2.0);
  EXPECT_LT(result.mean_distance, 1.0);
}

TEST(RelaxDual, AFullereneComesToRestAtItsEnergy) {
  Molecule molecule = scaled_dual(test::unit_sphere(4), test::scale_for(320, sphere_area));
  const TetherSurface surface(test::unit_sphere(12), test::scale_for(320, sphere_area));
  const DualRelaxationResult result = relax_dual(molecule, surface, {.tether = 0, .force_tolerance = 1e-3});
  // C320 (Ih) by LAMMPS's pair_style rebo.
  EXPECT_NEAR(result.energy / 320, -7.2409063626, 2e-6);
}

// Only its boundary holds a flat sheet in its plane: it goes back there, and comes to rest. Large enough for the
// preconditioner.
TEST(RelaxNetwork, AFlatSheetBesideItsPlaceGoesBack) {
  constexpr double edge = 2.46;
  const TriangleMesh sheet = test::equilateral_sheet(edge, 32, 33);
  TrivalentNetwork network = trivalent_network(sheet);
  network.hydrogen = true;
  std::vector<Vec3> positions;
  for (const Triangle& t : sheet.triangles) {
    const auto [a, b, c] = corners_of(sheet, t);
    positions.push_back((a + b + c) / 3 + Vec3(0.5, 0.3, 0));
  }
  ASSERT_GT(positions.size(), 2000u);
  const Vec3 at = positions[1000];
  const DualRelaxationResult result =
      relax_network(fixed_bond_graph(network, Space()), positions, TetherSurface(sheet, 1),
                    {.force_tolerance = 0.02, .free_mean = false});
  EXPECT_LT(result.max_force, 0.02);
  EXPECT_NEAR((positions[1000] - at + Vec3(0.5, 0.3, 0)).norm(), 0, 0.15);
}

// Bonds from an atom to every other.
std::vector<int> bonds_from(AtomIndex start, const FixedBondGraph& graph) {
  std::vector<int> steps(graph.neighbours.size(), -1);
  std::vector<AtomIndex> reached = {start};
  steps[start] = 0;
  for (std::size_t k = 0; k < reached.size(); ++k)
    for (const AtomIndex n : graph.neighbours[reached[k]])
      if (n != no_atom && steps[n] < 0) {
        steps[n] = steps[reached[k]] + 1;
        reached.push_back(n);
      }
  return steps;
}

TEST(RelaxBySprings, AroundAnAtomMendsItsBondsAndHoldsTheRest) {
  const std::size_t atoms = 20 * 12 * 12;
  Molecule molecule = scaled_dual(test::unit_sphere(12), test::scale_for(atoms, sphere_area));
  const TetherSurface surface(test::unit_sphere(24), test::scale_for(atoms, sphere_area));
  relax_dual(molecule, surface);
  FixedBondModel model;
  model.rebo2.set_graph(fixed_bond_graph(molecule));
  const FixedBondGraph& graph = model.rebo2.graph();
  constexpr AtomIndex moved = 1000;
  std::vector<Vec3> positions = molecule.positions;
  positions[moved] += 0.7 * (positions[graph.neighbours[moved][0]] - positions[moved]);
  const std::vector<Vec3> before = positions;
  model.planes = tangent_planes(surface, positions);
  relax_by_springs_around(model, surface, positions, std::vector<AtomIndex>{moved}, 400);
  const std::vector<int> steps = bonds_from(moved, graph);
  std::size_t changed = 0;
  for (AtomIndex a = 0; a < atoms; ++a) {
    changed += positions[a] != before[a] ? 1 : 0;
    if (steps[a] > 6) {
      ASSERT_EQ(positions[a], before[a]) << steps[a];
    }
    for (const AtomIndex n : graph.neighbours[a])
      ASSERT_NEAR((positions[a] - positions[n]).norm(), 1.42, 0.1);
  }
  EXPECT_GT(changed, 20u);
}

}  // namespace
}  // namespace nanocarbon::annealing
