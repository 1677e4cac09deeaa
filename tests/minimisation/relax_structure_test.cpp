// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/relax_structure.h"

#include <gtest/gtest.h>

#include "nanocarbon/potential/airebo/airebo.h"
#include "nanocarbon/potential/rebo2/rebo2.h"
#include "nanocarbon/structures/diamond.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphite.h"

namespace nanocarbon::minimisation {
namespace {

// The minima are LAMMPS's (fix box/relax).
TEST(RelaxStructure, GraphiteFindsItsBondsAndTheDistanceOfItsLayers) {
  Molecule m = structures::graphite({2, 2, 2}, structures::Stacking::ab, {1.41, 3.25}, false);
  airebo::Airebo airebo;
  const auto relaxed = relax_structure(m, airebo, {.free = {true, true, true}}, {.force_tolerance = 1e-6});
  EXPECT_TRUE(relaxed.converged);
  EXPECT_NEAR(relaxed.energy / static_cast<double>(m.size()), -7.4771092196, 1e-9);
  EXPECT_NEAR(m.cell->vectors(1, 1) / 6, 1.3957507, 1e-6);
  EXPECT_NEAR(m.cell->vectors(2, 2) / 2, 3.3579973, 2e-5);
}

TEST(RelaxStructure, EdgesThatAreNotFreeStay) {
  Molecule m = structures::graphite({2, 2, 2}, structures::Stacking::ab, {1.41, 3.25}, false);
  const Cell before = *m.cell;
  airebo::Airebo airebo;
  relax_structure(m, airebo, {.free = {false, false, true}}, {.force_tolerance = 1e-4});
  EXPECT_EQ(m.cell->vectors(0, 0), before.vectors(0, 0));
  EXPECT_NE(m.cell->vectors(2, 2), before.vectors(2, 2));
}

TEST(RelaxStructure, DiamondHasRebo2sLatticeConstant) {
  Molecule m = structures::diamond(1, 1, 1);
  m.cell->vectors *= 1.01;
  for (Vec3& p : m.positions) p *= 1.01;
  rebo2::Rebo2 rebo2;
  relax_structure(m, rebo2, {.free = {true, true, true}, .alike_across = true}, {.force_tolerance = 1e-6});
  EXPECT_NEAR(m.cell->vectors(0, 0), 3.5657, 1e-4);
  EXPECT_NEAR(m.cell->vectors(1, 1), m.cell->vectors(0, 0), 1e-12);
}

TEST(RelaxStructure, AMoleculeInFreeSpaceComesToRestAsByMinimiseMolecule) {
  Molecule m = structures::fullerene(1, 1);
  airebo::Airebo airebo;
  const auto relaxed = relax_structure(m, airebo, {}, {.force_tolerance = 1e-6});
  EXPECT_NEAR(relaxed.energy / 60, -6.8080046046, 1e-9);  // LAMMPS's airebo
}

}  // namespace
}  // namespace nanocarbon::minimisation
