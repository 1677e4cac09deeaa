// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "nanocarbon/minimisation/minimise_molecule.h"
#include "nanocarbon/potential/rebo2/rebo2.h"
#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon::multilevel {
namespace {

// To a minimum from 10% too wide and 5% too low.
int iterations_of_fullerene(int h) {
  Molecule molecule = structures::fullerene(h, h);
  for (Vec3& p : molecule.positions) p.x() *= 1.1, p.z() *= 0.95;
  rebo2::Rebo2 rebo2;
  const auto result = minimisation::minimise_molecule(molecule, rebo2, {.force_tolerance = 1e-3});
  EXPECT_TRUE(result.converged);
  EXPECT_TRUE(result.intact);
  return result.iterations;
}

// Without a preconditioner they grow with the number of atoms.
TEST(Iterations, HardlyGrowFromTwoThousandToThirtyFiveThousandAtoms) {
  const int small = iterations_of_fullerene(6), medium = iterations_of_fullerene(12),
            large = iterations_of_fullerene(24);
  EXPECT_LT(medium, 1.5 * small + 10);
  EXPECT_LT(large, 2 * small + 20);
  RecordProperty("iterations",
                 std::to_string(small) + " " + std::to_string(medium) + " " + std::to_string(large));
}

}  // namespace
}  // namespace nanocarbon::multilevel
