// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>

#include <Eigen/LU>
#include <limits>
#include <sstream>

#include "molecule/shapes.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/dual.h"
#include "nanocarbon/molecule/formats/lammps_box.h"
#include "nanocarbon/molecule/formats/lammps_data.h"

namespace nanocarbon::molecule {
namespace {

std::string written(const Molecule& molecule, const LammpsDataOptions& options = {}) {
  std::ostringstream out;
  write_lammps_data(out, molecule, options);
  return out.str();
}

Molecule c20() { return dual(test::scaled_to_carbon(test::icosahedron())); }

TEST(LammpsDataWriter, BeginsWithTheCallersComment) {
  const std::string text = written(c20(), {.comment = "nanocarbon 1.2 build a.off\n5 atoms"});
  EXPECT_THAT(text, testing::StartsWith("# nanocarbon 1.2 build a.off 5 atoms\n\n"));
}

TEST(LammpsDataWriter, HasTwoTypesAndBondsWhereTheStyleHasThem) {
  const std::string atomic = written(c20());
  EXPECT_THAT(atomic, testing::HasSubstr("\n20 atoms\n2 atom types\n"));
  EXPECT_THAT(atomic, testing::HasSubstr("\n1 12.011  # C\n2 1.008  # H\n"));
  EXPECT_THAT(atomic, testing::HasSubstr("\nAtoms # atomic\n"));
  EXPECT_THAT(atomic, testing::Not(testing::HasSubstr("Bonds")));
  const std::string full = written(c20(), {.atom_style = AtomStyle::full});
  EXPECT_THAT(full, testing::HasSubstr("\n30 bonds\n1 bond types\n"));
  EXPECT_THAT(full, testing::HasSubstr("\nAtoms # full\n\n1 1 1 0 "));
  EXPECT_THAT(full, testing::HasSubstr("\nBonds\n\n1 1 1 "));
}

TEST(LammpsDataWriter, EachComponentIsAMoleculeOfItsOwn) {
  Molecule two;
  two.positions = {Vec3(0, 0, 0), Vec3(9, 0, 0), Vec3(1.4, 0, 0)};
  two.elements = {Element::carbon, Element::hydrogen, Element::carbon};
  two.bonds = {{0, 2, {0, 0, 0}}};
  const std::string text = written(two, {.atom_style = AtomStyle::molecular});
  EXPECT_THAT(text, testing::HasSubstr("\n1 1 1 0 0 0\n2 2 2 9 0 0\n3 1 1 1.4 0 0\n"));
}

TEST(LammpsDataWriter, RefusesAtomsThatAreNowhere) {
  Molecule bad = c20();
  bad.positions[4][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(written(bad), UserError);
}

TEST(LammpsBox, LeavesTheMarginAroundAFreeMolecule) {
  const Molecule molecule = c20();
  const LammpsBox box = lammps_box(molecule, 7.0);
  EXPECT_FALSE(box.triclinic());
  Vec3 low = molecule.positions[0], high = low;
  for (const Vec3& p : molecule.positions) low = low.cwiseMin(p), high = high.cwiseMax(p);
  EXPECT_NEAR((box.cell.origin - (low - Vec3::Constant(7.0))).norm(), 0.0, 1e-12);
  EXPECT_NEAR((box.cell.vectors.diagonal() - (high - low + Vec3::Constant(14.0))).norm(), 0.0, 1e-12);
}

TEST(LammpsBox, TurnsACellIntoLammpsFormAndKeepsDistances) {
  Molecule molecule;
  molecule.positions = {Vec3(0.3, 0.2, 0.1), Vec3(1.1, -0.4, 2.0)};
  molecule.elements.assign(2, Element::carbon);
  molecule.cell = Cell{};
  molecule.cell->vectors << 0.2, 4.0, 3.5, 3.0, -0.3, 0.1, 0.1, 0.2, -5.0;
  if (molecule.cell->vectors.determinant() < 0) molecule.cell->vectors.col(2) *= -1.0;
  const LammpsBox box = lammps_box(molecule, 5.0);
  const Mat3& m = box.cell.vectors;
  EXPECT_EQ(m(1, 0), 0.0);
  EXPECT_EQ(m(2, 0), 0.0);
  EXPECT_EQ(m(2, 1), 0.0);
  EXPECT_GT(m.diagonal().minCoeff(), 0.0);
  EXPECT_NEAR(volume(box.cell), volume(*molecule.cell), 1e-10);
  EXPECT_LE(std::abs(m(0, 1)), 0.5 * m(0, 0) + 1e-9);
  EXPECT_LE(std::abs(m(0, 2)), 0.5 * m(0, 0) + 1e-9);
  EXPECT_LE(std::abs(m(1, 2)), 0.5 * m(1, 1) + 1e-9);
  EXPECT_NEAR((box.rotation * box.rotation.transpose() - Mat3::Identity()).norm(), 0.0, 1e-12);
  EXPECT_NEAR(box.rotation.determinant(), 1.0, 1e-12);
  // Each of the cell's vectors is a lattice vector of the box.
  const Mat3 multiples = m.inverse() * box.rotation * molecule.cell->vectors;
  EXPECT_NEAR((multiples - multiples.array().round().matrix()).norm(), 0.0, 1e-10);
}

TEST(LammpsBox, HasNoTiltAlongOpenDirections) {
  Molecule molecule;
  molecule.positions = {Vec3(0, 0, 0), Vec3(0, 0, 3)};
  molecule.elements.assign(2, Element::carbon);
  molecule.cell = Cell{};
  molecule.cell->vectors << 2.46, 1.23, 4.0, 0.0, 2.13, 1.0, 0.0, 0.0, 10.0;
  molecule.cell->periodic = {true, true, false};
  const LammpsBox box = lammps_box(molecule, 6.0);
  EXPECT_EQ(box.cell.vectors(0, 2), 0.0);
  EXPECT_EQ(box.cell.vectors(1, 2), 0.0);
  EXPECT_NEAR(box.cell.vectors(0, 1), 1.23, 1e-12);
  EXPECT_NEAR(box.cell.vectors(2, 2), 15.0, 1e-12);
  EXPECT_NEAR(box.cell.origin[2], -6.0, 1e-12);
}

}  // namespace
}  // namespace nanocarbon::molecule
