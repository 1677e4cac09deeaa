// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/rebo2.h"

#include <gmock/gmock.h>

#include "nanocarbon/core/error.h"
#include "nanocarbon/potential/rebo2/parameter_file.h"
#include "nanocarbon/structures/diamond.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/hydrocarbons.h"
#include "potential/rebo2/comparison_structures.h"
#include "support/temporary_folder.h"

namespace nanocarbon::rebo2 {
namespace {

const Cell* cell_of(const Molecule& m) { return m.cell ? &*m.cell : nullptr; }

double energy(const Molecule& m) { return Rebo2().evaluate(m.positions, m.elements, cell_of(m)).energy; }

void scale(Molecule& m, double factor) {
  for (Vec3& p : m.positions) p *= factor;
  if (m.cell) m.cell->vectors *= factor;
}

//! Energies at the minimum, 0 K: the bond of graphene under REBO2 is 1.4204 Angstrom, diamond has a
//! = 3.56572.
TEST(Rebo2, KnowsGrapheneAndDiamond) {
  Molecule sheet = structures::graphene(3, 2);
  const double bond = (sheet.positions[sheet.bonds[0].second] - sheet.positions[sheet.bonds[0].first]).norm();
  scale(sheet, 1.42039 / bond);
  EXPECT_NEAR(energy(sheet) / static_cast<double>(sheet.size()), -7.3949972517, 1e-6);
  const Molecule crystal = structures::diamond(1, 1, 1);
  EXPECT_NEAR(energy(crystal) / static_cast<double>(crystal.size()), -7.3699966410, 1e-6);
}

TEST(Rebo2, ForcesAreMinusTheGradient) {
  std::vector<Molecule> molecules = {structures::graphene(2, 1), structures::fullerene(1, 0),
                                     structures::cyclopropane(), structures::benzene(),
                                     structures::acetylene()};
  for (unsigned seed = 300; seed < 330; ++seed) molecules.push_back(test::random_cluster(seed));
  Rebo2 rebo2;
  for (Molecule& m : molecules) {
    test::rattle(m, 0.1, 9);
    const std::vector<Vec3> forces = rebo2.evaluate(m.positions, m.elements, cell_of(m)).forces;
    constexpr double step = 1e-5;
    for (std::size_t i = 0; i < m.size(); ++i)
      for (int d = 0; d < 3; ++d) {
        const double here = m.positions[i][d];
        m.positions[i][d] = here + step;
        const double up = rebo2.evaluate(m.positions, m.elements, cell_of(m)).energy;
        m.positions[i][d] = here - step;
        const double down = rebo2.evaluate(m.positions, m.elements, cell_of(m)).energy;
        m.positions[i][d] = here;
        // The third derivative inside a cut-off window is some 1e5 eV/Angstrom^3.
        EXPECT_NEAR(forces[i][d], (down - up) / (2.0 * step), 2e-5);
      }
  }
}

TEST(Rebo2, VirialIsTheDerivativeByStrain) {
  Molecule m = structures::diamond(1, 1, 1);
  test::rattle(m, 0.1, 2);
  const Mat3 virial = Rebo2().evaluate(m.positions, m.elements, cell_of(m)).virial;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      const auto strained = [&](double amount) {
        Mat3 strain = Mat3::Identity();
        strain(a, b) += amount;
        Molecule n = m;
        for (Vec3& p : n.positions) p = strain * p;
        n.cell->vectors = strain * n.cell->vectors;
        return energy(n);
      };
      EXPECT_NEAR(virial(b, a), (strained(-1e-5) - strained(1e-5)) / 2e-5, 1e-4);
    }
}

TEST(Rebo2, PartsAndAtomsAddUp) {
  for (const Molecule& m :
       {structures::fullerene(1, 1), structures::benzene(), structures::diamond(1, 1, 1)}) {
    Rebo2 rebo2;
    const Rebo2Result r =
        rebo2.evaluate(m.positions, m.elements, cell_of(m), {.atom_energies = true, .atom_virials = true});
    double sum = 0.0;
    for (const double e : r.atom_energies) sum += e;
    EXPECT_NEAR(sum, r.energy, 1e-10);
    EXPECT_NEAR(r.parts.total(), r.energy, 1e-10);
    Mat3 virial = Mat3::Zero();
    for (const Mat3& v : r.atom_virials) virial += v;
    EXPECT_LT((virial - r.virial).cwiseAbs().maxCoeff(), 1e-10);
    Vec3 force = Vec3::Zero();
    for (const Vec3& f : r.forces) force += f;
    EXPECT_LT(force.norm(), 1e-10);
  }
  // rebo2.md of the literature: the dihedral terms of C60 are worth 0.10 eV an atom.
  const Molecule c60 = structures::fullerene(1, 1);
  EXPECT_NEAR(Rebo2().evaluate(c60.positions, c60.elements).parts.dihedral / 60.0, 0.10, 0.005);
}

TEST(Rebo2, ACellAsSmallAsItsPrimitiveOneGivesTheSameEnergy) {
  Molecule primitive;
  primitive.positions = {Vec3(0, 0, 0), Vec3(0, 1.42, 0)};
  primitive.elements = {Element::carbon, Element::carbon};
  Cell cell;
  const double a = 1.42 * std::sqrt(3.0);
  cell.vectors.col(0) = Vec3(a, 0, 0);
  cell.vectors.col(1) = Vec3(0.5 * a, 1.5 * 1.42, 0);
  cell.vectors.col(2) = Vec3(0, 0, 20);
  primitive.cell = cell;
  Molecule large = structures::graphene(6, 4);
  const double bond = (large.positions[large.bonds[0].second] - large.positions[large.bonds[0].first]).norm();
  scale(large, 1.42 / bond);
  EXPECT_NEAR(energy(primitive) / 2.0, energy(large) / static_cast<double>(large.size()), 1e-8);
}

TEST(Rebo2, NothingAndSingleAtomsHaveNoEnergy) {
  Rebo2 rebo2;
  EXPECT_EQ(rebo2.evaluate({}, {}).energy, 0.0);
  const std::vector<Vec3> one = {Vec3(1, 2, 3)};
  const std::vector<Element> carbon = {Element::carbon};
  EXPECT_EQ(rebo2.evaluate(one, carbon).energy, 0.0);
}

TEST(ParameterFile, SaysWhereItIsWrong) {
  const test::TemporaryFolder folder;
  const std::string path =
      folder.file("wrong.rebo", "# DATE\n# REBO2 Brenner\n\n1.7 rcmin_CC\n1.3 rcmin_CH\nabc rcmin_HH\n");
  try {
    read_rebo2_parameters(path);
    FAIL();
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(path + ", line 6: expected a number (rcmin), found 'abc'"));
  }
  EXPECT_THROW(read_rebo2_parameters("no such file"), UserError);
}

std::string error_of_parameters(const std::string& text) {
  const test::TemporaryFolder folder;
  try {
    read_rebo2_parameters(folder.file("wrong.rebo", text));
  } catch (const UserError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(ParameterFile, TakesFiniteNumbersOnly) {
  for (const std::string word : {"nan", "inf", "-inf", "1e999", "0x10", "1,5", "--1"})
    EXPECT_THAT(error_of_parameters("# DATE\n# REBO2 Brenner\n1.7 rcmin_CC\n" + word + " rcmin_CH\n"),
                testing::HasSubstr("line 4: expected a number (rcmin), found '" + word + "'"));
}

// Counts that no whole number holds, too.
TEST(ParameterFile, SaysHowManyKnotsItFound) {
  std::string labelled = "# DATE\n# REBO2 Brenner\n";
  for (int n = 0; n < 65; ++n) labelled += "1 name\n";
  for (const std::string count : {"4", "5.5", "-1", "1e300"})
    EXPECT_THAT(error_of_parameters(labelled + count + "\n"),
                testing::HasSubstr("line 68: gC: expected 5 knots, found " + count));
}

}  // namespace
}  // namespace nanocarbon::rebo2
