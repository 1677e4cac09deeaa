// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/minimise_molecule.h"

#include <gtest/gtest.h>

#include "nanocarbon/potential/rebo2/rebo2.h"
#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon::minimisation {
namespace {

TEST(MinimiseMolecule, C240ComesToRestAtLammpssEnergyWithForcesBelowAMillionth) {
  Molecule molecule = structures::fullerene(2, 2);
  rebo2::Rebo2 rebo2;
  const auto result = minimise_molecule(molecule, rebo2, {.force_tolerance = 1e-6});
  EXPECT_TRUE(result.converged);
  EXPECT_TRUE(result.intact);
  EXPECT_LT(result.max_force, 1e-6);
  // LAMMPS's pair_style rebo, minimised; eV/atom.
  EXPECT_NEAR(result.energy / 240, -7.2050937785, 1e-9);
  for (const Vec3& force : rebo2.evaluate(molecule.positions, molecule.elements).forces)
    EXPECT_LT(force.norm(), 1e-6);
}

TEST(MinimiseMolecule, SaysWhenBondsAreNotThoseThatTheCutOffSees) {
  Molecule molecule = structures::fullerene(1, 1);
  molecule.bonds.pop_back();
  rebo2::Rebo2 rebo2;
  EXPECT_FALSE(minimise_molecule(molecule, rebo2, {.max_iterations = 1}).intact);
}

}  // namespace
}  // namespace nanocarbon::minimisation
