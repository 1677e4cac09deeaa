// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/minimise_molecule.h"

#include <gtest/gtest.h>

#include <memory>

#include "nanocarbon/potential/airebo/airebo.h"
#include "nanocarbon/potential/rebo2/rebo2.h"
#include "nanocarbon/structures/fullerene.h"
#include "support/facing_benzenes.h"

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

class Facing : public testing::TestWithParam<bool> {
 protected:
  std::unique_ptr<potential::Potential> potential() const {
    if (GetParam()) return std::make_unique<airebo::Airebo>();
    return std::make_unique<rebo2::Rebo2>();
  }
  // As it is: no force is too large.
  bool intact(Molecule molecule) const {
    return minimise_molecule(molecule, *potential(), {.force_tolerance = 1e9}).intact;
  }
};

TEST_P(Facing, HydrogensCountAsBoundBelowOnePointThree) {
  for (const double distance : {1.31, 1.4, 1.65, 1.75})
    EXPECT_TRUE(intact(test::hydrogen_to_hydrogen(distance))) << distance;
  for (const double distance : {0.74, 1.1, 1.29})
    EXPECT_FALSE(intact(test::hydrogen_to_hydrogen(distance))) << distance;
}

// Why they may come so close: from farther away nothing draws them together.
TEST_P(Facing, HydrogensRepelEachOtherUpToThere) {
  const auto energy = [&](double distance) {
    const Molecule molecule = test::hydrogen_to_hydrogen(distance);
    return potential()->evaluate(molecule.positions, molecule.elements, nullptr, {}).energy;
  };
  for (double distance = 1.3; distance < 1.7; distance += 0.05)
    EXPECT_GT(energy(distance), energy(distance + 0.05) + 1e-4) << distance;
}

TEST_P(Facing, HydrogenAndCarbonCountAsBoundWhereverTheyAreSeen) {
  EXPECT_TRUE(intact(test::hydrogen_to_carbon(1.85)));
  for (const double distance : {1.75, 1.5, 1.35})
    EXPECT_FALSE(intact(test::hydrogen_to_carbon(distance))) << distance;
}

INSTANTIATE_TEST_SUITE_P(Benzenes, Facing, testing::Bool(),
                         [](const auto& airebo) { return airebo.param ? "airebo" : "rebo2"; });

}  // namespace
}  // namespace nanocarbon::minimisation
