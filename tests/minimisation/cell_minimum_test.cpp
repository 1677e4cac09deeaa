// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/cell_minimum.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nanocarbon/potential/airebo/airebo.h"
#include "nanocarbon/potential/rebo2/rebo2.h"
#include "nanocarbon/structures/diamond.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/graphite.h"
#include "nanocarbon/structures/schwarzite.h"

namespace nanocarbon::minimisation {
namespace {

constexpr double graphene_energy = -7.394997;  // eV an atom, LAMMPS's pair_style rebo

void strain(Molecule& molecule, const Mat3& deformation) {
  for (Vec3& p : molecule.positions) p = deformation * p;
  molecule.cell->vectors = deformation * molecule.cell->vectors;
}

// Energies and cells by LAMMPS (29 Sep 2021), pair_style rebo, fix box/relax tri.
TEST(CellMinimum, SchwarzitesComeBackToLammpssCellFromAStrain) {
  rebo2::Rebo2 potential;
  Mat3 deformation;
  deformation << 1.03, 0.01, 0, 0.01, 0.98, 0.005, 0, 0.005, 1.01;
  Molecule p688 = structures::schwarzite_p688(2, 2, 2);
  strain(p688, deformation);
  const CellMinimum result =
      minimise_in_cell(p688, potential, CellRelaxation::triclinic, {.force_tolerance = 1e-5});
  EXPECT_TRUE(result.minimum.converged && result.minimum.intact);
  EXPECT_NEAR(1e3 * (result.minimum.energy / static_cast<double>(p688.size()) - graphene_energy), 276.14,
              0.02);
  EXPECT_NEAR(std::cbrt(volume(*p688.cell)) / 2, 7.8006, 2e-4);
  EXPECT_LT(result.stress.cwiseAbs().maxCoeff(), 1e-5);
}

TEST(CellMinimum, OneStrainLeavesTheShape) {
  rebo2::Rebo2 potential;
  Molecule d688 = structures::schwarzite_d688(2, 2, 2);
  strain(d688, 1.02 * Mat3::Identity());
  const CellMinimum result =
      minimise_in_cell(d688, potential, CellRelaxation::isotropic, {.force_tolerance = 1e-5});
  EXPECT_NEAR(1e3 * (result.minimum.energy / static_cast<double>(d688.size()) - graphene_energy), 149.31,
              0.02);
  EXPECT_NEAR(d688.cell->vectors(0, 0), 2 * 6.0635, 5e-4);
  EXPECT_EQ(d688.cell->vectors(0, 1), 0);
  EXPECT_LT(std::abs(result.stress.trace()), 1e-5);
}

TEST(CellMinimum, OnlyPeriodicDirectionsAreStrained) {
  rebo2::Rebo2 potential;
  Molecule sheet = structures::graphene(6, 4);
  const Mat3 before = sheet.cell->vectors;
  for (Vec3& p : sheet.positions) p.x() *= 1.02;
  sheet.cell->vectors(0, 0) *= 1.02;
  const CellMinimum result =
      minimise_in_cell(sheet, potential, CellRelaxation::triclinic, {.force_tolerance = 1e-5});
  EXPECT_NEAR(result.minimum.energy / static_cast<double>(sheet.size()), graphene_energy, 1e-6);
  EXPECT_NEAR(sheet.cell->vectors(0, 0) / before(0, 0), 1, 1e-3);
  EXPECT_EQ(sheet.cell->vectors(2, 2), before(2, 2));
}

TEST(CellMinimum, NoStrainIsTheMinimumInTheCellAsItIs) {
  rebo2::Rebo2 potential;
  Molecule p688 = structures::schwarzite_p688(2, 2, 2);
  strain(p688, 1.01 * Mat3::Identity());
  const Mat3 before = p688.cell->vectors;
  const CellMinimum result =
      minimise_in_cell(p688, potential, CellRelaxation::none, {.force_tolerance = 1e-4});
  EXPECT_EQ(p688.cell->vectors, before);
  EXPECT_GT(result.stress.trace(), 0) << "it pulls inwards";
}

// LAMMPS's fix box/relax.
TEST(CellMinimum, GraphiteFindsItsBondsAndTheDistanceOfItsLayers) {
  airebo::Airebo airebo;
  for (const CellRelaxation relaxation : {CellRelaxation::orthogonal, CellRelaxation::uniaxial}) {
    Molecule m = structures::graphite({2, 2, 2}, structures::Stacking::ab, {1.41, 3.25}, false);
    const CellMinimum result = minimise_in_cell(m, airebo, relaxation, {.force_tolerance = 1e-6});
    EXPECT_TRUE(result.minimum.converged);
    EXPECT_NEAR(result.minimum.energy / static_cast<double>(m.size()), -7.4771092196, 1e-9);
    EXPECT_NEAR(m.cell->vectors(1, 1) / 6, 1.3957507, 1e-6);
    EXPECT_NEAR(m.cell->vectors(2, 2) / 2, 3.3579973, 2e-5);
  }
}

TEST(CellMinimum, AcrossCTheTwoEdgesChangeAlike) {
  Molecule m = structures::diamond(1, 1, 1);
  strain(m, Vec3(1.01, 1.01, 0.98).asDiagonal());
  rebo2::Rebo2 rebo2;
  minimise_in_cell(m, rebo2, CellRelaxation::uniaxial, {.force_tolerance = 1e-6});
  EXPECT_NEAR(m.cell->vectors(0, 0), 3.5657, 1e-4);
  EXPECT_NEAR(m.cell->vectors(2, 2), 3.5657, 1e-4);
  EXPECT_NEAR(m.cell->vectors(1, 1), m.cell->vectors(0, 0), 1e-12);
}

TEST(CellMinimum, AMoleculeInFreeSpaceComesToRestAsByMinimiseMolecule) {
  Molecule m = structures::fullerene(1, 1);
  airebo::Airebo airebo;
  const CellMinimum result = minimise_in_cell(m, airebo, CellRelaxation::uniaxial, {.force_tolerance = 1e-6});
  EXPECT_NEAR(result.minimum.energy / 60, -6.8080046046, 1e-9);  // LAMMPS's airebo
  EXPECT_EQ(result.deformation, Mat3::Identity());
}

}  // namespace
}  // namespace nanocarbon::minimisation
