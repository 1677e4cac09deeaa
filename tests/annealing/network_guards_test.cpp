// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/network_guards.h"

#include <gtest/gtest.h>

#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon::annealing {
namespace {

TEST(Guards, LeaveASoundMoleculeAlone) {
  const Molecule molecule = structures::fullerene(1, 1);
  std::vector<Vec3> gradient(60, Vec3::Zero());
  EXPECT_EQ(add_guards(fixed_bond_graph(molecule), molecule.positions, gradient), 0);
  for (const Vec3& g : gradient) EXPECT_EQ(g.norm(), 0);
}

TEST(Guards, GradientIsThatOfTheEnergy) {
  Molecule molecule = structures::fullerene(1, 1);
  const FixedBondGraph graph = fixed_bond_graph(molecule);
  molecule.positions[7] += Vec3(0.5, 0.6, -0.4);  // stretches bonds and closes angles
  std::vector<Vec3> gradient(60, Vec3::Zero()), unused(60, Vec3::Zero());
  EXPECT_GT(add_guards(graph, molecule.positions, gradient), 0.1);
  const double h = 1e-6;
  for (std::size_t a = 0; a < 60; ++a)
    for (int d = 0; d < 3; ++d) {
      std::vector<Vec3> moved = molecule.positions;
      moved[a][d] += h;
      const double ahead = add_guards(graph, moved, unused);
      moved[a][d] -= 2 * h;
      EXPECT_NEAR(gradient[a][d], (ahead - add_guards(graph, moved, unused)) / (2 * h), 1e-6);
    }
}

}  // namespace
}  // namespace nanocarbon::annealing
