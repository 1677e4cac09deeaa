#include "nanocarbon/relaxation/minimise_rebo2.h"

#include <gtest/gtest.h>

#include "nanocarbon/rebo2/rebo2.h"
#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon {
namespace {

TEST(MinimiseRebo2, C240ComesToRestAtLammpssEnergyWithForcesBelowAMillionth) {
  Molecule molecule = fullerene(2, 2);
  const auto result = minimise_rebo2(molecule, {.force_tolerance = 1e-6});
  EXPECT_TRUE(result.converged);
  EXPECT_TRUE(result.intact);
  EXPECT_LT(result.max_force, 1e-6);
  // LAMMPS's pair_style rebo, minimised; eV/atom.
  EXPECT_NEAR(result.energy / 240, -7.2050937785, 1e-9);
  Rebo2 rebo2;
  for (const Vec3& force : rebo2.evaluate(molecule.positions, molecule.elements).forces)
    EXPECT_LT(force.norm(), 1e-6);
}

TEST(MinimiseRebo2, SaysWhenBondsAreNotThoseThatTheCutOffSees) {
  Molecule molecule = fullerene(1, 1);
  molecule.bonds.pop_back();
  EXPECT_FALSE(minimise_rebo2(molecule, {.max_iterations = 1}).intact);
}

}  // namespace
}  // namespace nanocarbon
