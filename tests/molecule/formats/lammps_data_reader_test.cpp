// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>

#include <random>
#include <sstream>

#include "molecule/shapes.h"
#include "nanocarbon/molecule/bond_statistics.h"
#include "nanocarbon/molecule/dual.h"
#include "nanocarbon/molecule/formats/lammps_data.h"
#include "nanocarbon/topology/bond_graph.h"
#include "support/read_text.h"

namespace nanocarbon::molecule {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

MoleculeFrame read(const std::string& text, const MoleculeReadOptions& options = {}) {
  return test::read_frames(text, "test.data", options).at(0);
}

std::string error_of(const std::string& text, const MoleculeReadOptions& options = {}) {
  return test::error_of_text(text, "test.data", options);
}

MoleculeFrame written_and_read(const Molecule& molecule, AtomStyle style) {
  std::ostringstream out;
  LammpsDataOptions options;
  options.atom_style = style;
  write_lammps_data(out, molecule, options);
  return read(out.str());
}

// As LAMMPS (29 Sep 2021) write_data writes it, by its documentation: atoms in any order, image flags,
// velocities.
const std::string by_write_data = R"(LAMMPS data file via write_data, version 29 Sep 2021, timestep = 10

4 atoms
2 atom types
2 bonds
1 bond types

-0.5 9.5 xlo xhi
0.0 20.0 ylo yhi
0.0 20.0 zlo zhi

Masses

1 12.0107
2 1.00794

Pair Coeffs # rebo

Bond Coeffs # harmonic

1 300 1.42

Atoms # molecular

3 1 2 9.4 1.0 1.0 0 0 0
1 1 1 -0.4 1.0 1.0 1 0 0
4 2 1 5.0 5.0 5.0 0 0 0
2 1 1 1.0 1.0 1.0 1 0 0

Velocities

3 0.1 0.2 0.3
1 0 0 0
4 0 0 0
2 0 0 0

Bonds

1 1 2 1
2 1 1 3
)";

TEST(LammpsDataReader, ReadsWhatWriteDataWrites) {
  const MoleculeFrame data = read(by_write_data);
  EXPECT_THAT(data.ids, ElementsAre(1, 2, 3, 4));
  const Molecule& m = data.molecule;
  EXPECT_THAT(m.elements, ElementsAre(Element::carbon, Element::carbon, Element::hydrogen, Element::carbon));
  EXPECT_EQ(m.positions[0], Vec3(9.6, 1, 1));
  EXPECT_EQ(m.positions[2], Vec3(9.4, 1, 1));
  ASSERT_TRUE(m.cell);
  EXPECT_EQ(m.cell->origin, Vec3(-0.5, 0, 0));
  EXPECT_EQ(m.cell->periodic, (std::array{true, true, true}));
  EXPECT_THAT(m.bonds, ElementsAre(Bond{0, 1, {0, 0, 0}}, Bond{0, 2, {0, 0, 0}}));
}

TEST(LammpsDataReader, ReadsWhatAseWrites) {
  const MoleculeFrame data = read(
      "ch.data (written by ASE) \n\n2 \t atoms \n2  atom types\n0.0      2.5  xlo xhi\n0.0      4.0  ylo "
      "yhi\n"
      "0.0      9.0  zlo zhi\n      1.25       0       0  xy xz yz\n\n\nAtoms \n\n"
      "     1   1        0  1  2\n     2   2      1.5    1    2\n",
      {.types = {"C", "H"}});
  EXPECT_THAT(data.molecule.elements, ElementsAre(Element::carbon, Element::hydrogen));
  EXPECT_EQ(data.molecule.cell->vectors(0, 1), 1.25);
}

TEST(LammpsDataReader, GivesBackWhatTheWriterWrote) {
  const Molecule molecule = dual(test::scaled_to_carbon(test::sqrt3_subdivided_sphere(test::icosahedron())));
  for (const AtomStyle style :
       {AtomStyle::atomic, AtomStyle::charge, AtomStyle::molecular, AtomStyle::full}) {
    const MoleculeFrame data = written_and_read(molecule, style);
    EXPECT_FALSE(data.molecule.cell);
    EXPECT_TRUE(data.molecule.positions == molecule.positions);  // to the last bit
    EXPECT_EQ(data.molecule.elements, molecule.elements);
    if (has_bonds(style)) {
      EXPECT_TRUE(data.molecule.bonds == molecule.bonds);
    }
  }
}

TEST(LammpsDataReader, GivesBackPeriodicMoleculesInAnyCell) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.5, 2.5);
  Molecule molecule;
  molecule.cell = Cell{};
  molecule.cell->vectors << 0.3, 7.0, 1.0, 6.0, -0.5, 2.0, 0.1, 0.4, -8.0;
  molecule.cell->origin = Vec3(1, 2, 3);
  for (int i = 0; i < 60; ++i) {
    molecule.positions.push_back(molecule.cell->vectors *
                                 Vec3(uniform(random), uniform(random), uniform(random)));
    molecule.elements.push_back(Element::carbon);
  }
  molecule.bonds = topology::bonds_within(molecule.positions, molecule.elements, &*molecule.cell);
  ASSERT_GT(molecule.bonds.size(), 10u);
  const Molecule back = written_and_read(molecule, AtomStyle::full).molecule;
  EXPECT_TRUE(topology::bonded_ids(back.bonds) == topology::bonded_ids(molecule.bonds));
  const auto before = bond_lengths(molecule), after = bond_lengths(back);
  for (std::size_t b = 0; b < before.size(); ++b) EXPECT_NEAR(before[b], after[b], 1e-12);
}

TEST(LammpsDataReader, TellsBondsToSeveralImagesOfOneAtomApart) {
  // A chain of two atoms in a cell of 2.8 Angstrom: both neighbours of each are images of the other.
  Molecule chain;
  chain.positions = {Vec3(0.1, 0, 0), Vec3(1.5, 0, 0)};
  chain.elements.assign(2, Element::carbon);
  chain.cell = orthogonal_cell(Vec3(2.8, 10, 10));
  chain.bonds = {{0, 1, {-1, 0, 0}}, {0, 1, {0, 0, 0}}};
  EXPECT_TRUE(written_and_read(chain, AtomStyle::molecular).molecule.bonds == chain.bonds);
}

TEST(LammpsDataReader, ReadsTypeLabelsAndGeneralCells) {
  const MoleculeFrame data = read(
      "x\n\n2 atoms\n2 atom types\n0 4 0 avec\n-4 0 0 bvec\n0 0 5 cvec\n1 1 1 abc origin\n\nAtom Type "
      "Labels\n\n1 H\n2 C\n\n"
      "Masses\n\nH 1.008\nC 12.011\n\nSome Fix's Section\n\n7 8 9\n\nAtoms # charge\n\n9 C -0.1 1 1 1\n4 H 0 "
      "2 2 2\n");
  EXPECT_THAT(data.ids, ElementsAre(4, 9));
  EXPECT_THAT(data.molecule.elements, ElementsAre(Element::hydrogen, Element::carbon));
  EXPECT_EQ(data.molecule.cell->vectors.col(1), Vec3(-4, 0, 0));
}

const std::string head = "x\n\n2 atoms\n1 atom types\n1 bonds\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n\n";

TEST(LammpsDataReader, OptionsGoBeforeWhatTheFileSays) {
  const std::string text = head + "Masses\n\n1 28.0855\n\nAtoms # atomic\n\n1 1 1 1 1\n2 1 2 2 2\n";
  EXPECT_THAT(error_of(text), HasSubstr("atom type 1 (mass 28.0855 g/mol) is silicon (Si)"));
  MoleculeReadOptions options;
  options.types = {"C"};
  options.periodic = {false, false, false};
  const MoleculeFrame data = read(text, options);
  EXPECT_THAT(data.molecule.elements, testing::Each(Element::carbon));
  EXPECT_FALSE(data.molecule.cell);
}

TEST(LammpsDataReader, ErrorsNameFileAndLine) {
  const std::string carbon = head + "Masses\n\n1 12.011\n\n";  // 12 lines
  EXPECT_THAT(error_of(carbon + "Atoms # atomic\n\n1 1 0 0 0\n2 1 0 zero 0\n"),
              AllOf(HasSubstr("test.data:17: "), HasSubstr("the line is \"2 1 0 zero 0\"")));
  EXPECT_THAT(error_of(carbon + "Atoms # atomic\n\n1 1 0 0 0\n2 1 0 0\n"),
              HasSubstr("test.data:17: expected 5 or 8"));
  EXPECT_THAT(error_of(carbon + "Atoms # atomic\n\n1 1 0 0 0\n"), HasSubstr("the header says 2 atoms"));
  EXPECT_THAT(error_of(carbon + "Atoms # atomic\n\n1 1 0 0 0\n1 1 0 0 nan\n"), HasSubstr("a finite number"));
  EXPECT_THAT(error_of(carbon + "Atoms # atomic\n\n7 1 0 0 0\n7 1 0 0 2\n"),
              HasSubstr("already used on line 16"));
  EXPECT_THAT(error_of(carbon + "Atoms # atomic\n\n1 1 0 0 0\n2 5 0 0 2\n"), HasSubstr("'5' is not one of"));
  EXPECT_THAT(error_of(carbon + "Atoms\n\n1 1 1 0 0 0\n2 1 1 0 0 2\n\nBonds\n\n1 1 1 3\n"),
              HasSubstr("test.data:21: "));
  EXPECT_THAT(error_of("x\n\n1 atoms\n1 atom types\n\nAtoms\n\n1 1 0 0 0\n"),
              HasSubstr("does not give a box"));
  EXPECT_THAT(error_of(head), HasSubstr("no Atoms section"));
  EXPECT_THAT(error_of(""), HasSubstr("the file is empty"));
  EXPECT_THAT(error_of(carbon + "Atoms\n\n1 1 0 0\n2 1 0 0\n"), HasSubstr("give it with --atom-style"));
}

TEST(LammpsDataReader, AMissingFileIsUnreadable) {
  try {
    read_molecule("/nowhere/at-all.data");
    FAIL() << "nothing was thrown";
  } catch (const UserError& error) {
    EXPECT_EQ(error.failure(), Failure::unreadable);
  }
}

// Two atoms of two types, as a bilayer or an adsorbate has them.
std::string two_types(const std::string& masses, const std::string& labels = {}) {
  return "x\n\n2 atoms\n2 atom types\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n\n" + labels + masses +
         "Atoms # atomic\n\n1 1 1 1 1\n2 2 2 2 2\n";
}

TEST(LammpsDataReader, GuessesNoElement) {
  EXPECT_THAT(error_of(two_types("")), AllOf(HasSubstr("test.data:11: "), HasSubstr("--types C C")));
  // Gold on graphene, and what names it.
  EXPECT_THAT(error_of(two_types("Masses\n\n1 12.011\n2 196.97\n\n")),
              HasSubstr("test.data:17: atom type 2 (mass 196.97 g/mol) is gold (Au)"));
  // Masses that stand for none: in units lj, or by programs that know none.
  EXPECT_THAT(error_of(two_types("Masses\n\n1 1.0\n2 1.0\n\n")), HasSubstr("nothing in the file says"));
  // A united atom, CH2.
  EXPECT_THAT(error_of(two_types("Masses\n\n1 12.011\n2 13.019\n\n")),
              HasSubstr("a mass that no element has"));
  // A bead of a coarse model, which Martini calls C1: the name does not stand above the mass.
  EXPECT_THAT(error_of(two_types("Masses\n\n1 12.011\n2 72.0 # C1\n\n")),
              HasSubstr("a mass that no element has"));
  // A name that says the opposite of the mass.
  EXPECT_THAT(error_of(two_types("Masses\n\n1 12.011 # H\n2 1.008 # C\n\n")),
              HasSubstr("has the mass of carbon, but is called hydrogen"));
}

TEST(LammpsDataReader, TakesElementsFromMassesLabelsCommentsAndOptions) {
  const auto carbon_and_hydrogen = testing::ElementsAre(Element::carbon, Element::hydrogen);
  for (const std::string masses :
       {"Masses\n\n1 12.0107\n2 1.00794\n\n", "Masses\n\n1 12\n2 1\n\n", "Masses\n\n1 1.0 # C\n2 1.0 # H\n\n",
        "Masses\n\n1 12.01115 # cp\n2 1.008 # hc\n\n", "Masses\n\n1 13.00335\n2 2.014\n\n"})
    EXPECT_THAT(read(two_types(masses)).molecule.elements, carbon_and_hydrogen) << masses;
  const std::string labels = "Atom Type Labels\n\n1 C_top\n2 hydrogen\n\n";
  EXPECT_THAT(read(two_types("", labels)).molecule.elements, carbon_and_hydrogen);
  const std::string own_names = "Atom Type Labels\n\n1 CA\n2 HA\n\n";
  EXPECT_THAT(error_of(two_types("", own_names)), HasSubstr("'CA'"));
  for (const std::vector<std::string>& types :
       std::vector<std::vector<std::string>>{{"CA=C", "HA=H"}, {"C", "H"}, {"1=C,2=H"}, {"C,H"}})
    EXPECT_THAT(read(two_types("", own_names), {.types = types}).molecule.elements, carbon_and_hydrogen);
  EXPECT_THAT(error_of(two_types(""), {.types = {"C", "C", "C"}}), HasSubstr("gives 3 types"));
  EXPECT_THAT(error_of(two_types(""), {.types = {"C", "Au"}}), HasSubstr("gold"));
  EXPECT_THAT(error_of(two_types(""), {.types = {"C", "2=H"}}),
              HasSubstr("some types have names and some do not"));
  const MoleculeFrame against = read(two_types("Masses\n\n1 28.0855\n2 1.008\n\n"), {.types = {"C", "H"}});
  EXPECT_THAT(against.warnings, ElementsAre(HasSubstr("has the mass of silicon, but --types says carbon")));
}

// A type that no atom is of may be anything.
TEST(LammpsDataReader, PassesOverTypesThatNoAtomIsOf) {
  const std::string text =
      "x\n\n1 atoms\n2 atom types\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n\nMasses\n\n1 12.011\n2 196.97\n\n"
      "Atoms # atomic\n\n1 1 1 1 1\n";
  EXPECT_THAT(read(text).molecule.elements, ElementsAre(Element::carbon));
}

// Columns as in LAMMPS's documentation of read_data; the position is (1.5, 2.5, 3.5) in each.
TEST(LammpsDataReader, ReadsEveryAtomStyle) {
  const std::vector<std::pair<std::string, std::string>> atoms = {
      {"atomic", "1 1 1.5 2.5 3.5"},
      {"charge", "1 1 -0.5 1.5 2.5 3.5"},
      {"bond", "1 7 1 1.5 2.5 3.5"},
      {"full", "1 7 1 0.25 1.5 2.5 3.5 0 0 0"},
      {"body", "1 1 0 12.0 1.5 2.5 3.5"},
      {"dipole", "1 1 0.1 1.5 2.5 3.5 0 0 1"},
      {"dpd", "1 1 1.0 1.5 2.5 3.5"},
      {"edpd", "1 1 1.0 2.0 1.5 2.5 3.5"},
      {"electron", "1 1 0 1 0.5 1.5 2.5 3.5"},
      {"ellipsoid", "1 1 0 2.2 1.5 2.5 3.5"},
      {"hybrid", "1 1 1.5 2.5 3.5 7 0.5 9 9"},
      {"line", "1 7 1 0 2.2 1.5 2.5 3.5"},
      {"peri", "1 1 1.0 2.2 1.5 2.5 3.5"},
      {"smd", "1 1 7 1 12 1 1 0 0 0 1.5 2.5 3.5"},
      {"sphere", "1 1 1.4 2.2 1.5 2.5 3.5 0 0 0"},
      {"spin", "1 1 1.5 2.5 3.5 0 0 1 1.0"},
      {"template", "1 7 1 1 1 1.5 2.5 3.5"},
      {"tri", "1 7 1 0 2.2 1.5 2.5 3.5"},
      {"wavepacket", "1 1 0 1 0.5 1 0.1 0.1 1.5 2.5 3.5"},
  };
  const std::string start =
      "x\n\n1 atoms\n1 atom types\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n\nMasses\n\n1 12.011\n\n";
  for (const auto& [style, line] : atoms) {
    EXPECT_EQ(read(start + "Atoms # " + style + "\n\n" + line + "\n").molecule.positions.at(0),
              Vec3(1.5, 2.5, 3.5))
        << style;
    EXPECT_EQ(read(start + "Atoms\n\n" + line + "\n", {.atom_style = style}).molecule.positions.at(0),
              Vec3(1.5, 2.5, 3.5))
        << style;
  }
  EXPECT_THAT(error_of(start + "Atoms\n\n1 1 0 0 0\n", {.atom_style = "cubic"}),
              HasSubstr("'cubic' is not a LAMMPS atom style"));
}

TEST(LammpsDataReader, TellsStylesWithoutCommentByAllOfTheirLines) {
  const auto first = [](const std::string& atoms) {
    const std::string start =
        "x\n\n2 atoms\n2 atom types\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n\nMasses\n\n1 12.011\n2 "
        "1.008\n\n";
    return read(start + "Atoms # of my sheet\n\n" + atoms).molecule.elements;
  };
  const auto carbon_and_hydrogen = testing::ElementsAre(Element::carbon, Element::hydrogen);
  EXPECT_THAT(first("1 1 1 1 1\n2 2 2 2 2\n"), carbon_and_hydrogen);
  EXPECT_THAT(first("1 7 1 1 1 1\n2 7 2 2 2 2\n"), carbon_and_hydrogen);     // molecular
  EXPECT_THAT(first("1 1 0 1 1 1\n2 2 0 2 2 2\n"), carbon_and_hydrogen);     // charge, written as 0
  EXPECT_THAT(first("1 1 1 1 1 1\n2 2 -0.5 2 2 2\n"), carbon_and_hydrogen);  // charge, by the second line
  EXPECT_THAT(first("1 1 1 1 1 1 0 0 -1\n2 1 2 2 2 2 0 0 0\n"),
              carbon_and_hydrogen);                                             // molecular with images
  EXPECT_THAT(first("1 1 1 0 1 1 1\n2 1 2 0.5 2 2 2\n"), carbon_and_hydrogen);  // full
}

// The first line of write_data and of -restart2data, as LAMMPS has it since 2022.
TEST(LammpsDataReader, RefusesLengthsThatAreNotInAngstrom) {
  const auto with_units = [](const std::string& units) {
    return "LAMMPS data file via write_data, version 2 Aug 2023, timestep = 0, units = " + units +
           two_types("Masses\n\n1 12.011\n2 1.008\n\n").substr(1);
  };
  for (const char* units : {"metal", "real"}) EXPECT_EQ(read(with_units(units)).molecule.size(), 2u);
  for (const char* units : {"lj", "electron", "si", "cgs", "micro", "nano"})
    EXPECT_THAT(error_of(with_units(units)), AllOf(HasSubstr("test.data:1: "), HasSubstr(units)));
}

// LAMMPS itself needs no blank line before the name of a section.
TEST(LammpsDataReader, TakesSectionsWithoutBlankLines) {
  EXPECT_THAT(
      read("x\n2 atoms\n2 atom types\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\nAtom Type Labels\n1 C\n2 H\n"
           "Masses\nC 12.011\nH 1.008\nPair Coeffs\n1 0.1 3.4\n2 0.1 2.5\nAtoms # atomic\n1 C 1 1 1\n"
           "2 H 2 2 2\nVelocities\n1 9 9 9\n2 9 9 9\n")
          .molecule.elements,
      ElementsAre(Element::carbon, Element::hydrogen));
}

TEST(LammpsDataReader, TakesAnyBlanksAndLineEnds) {
  const std::string plain = two_types("Masses\n\n1 12.011  # C\n2 1.008  # H\n\n");
  const Molecule expected = read(plain).molecule;
  std::string tabs = plain, windows, mac = plain, trailing;
  for (char& c : tabs)
    if (c == ' ') c = '\t';
  for (char& c : mac)
    if (c == '\n') c = '\r';
  for (const char c : plain) {
    windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    trailing += c == '\n' ? std::string(" \t \n  ") : std::string(1, c);
  }
  for (const std::string& text : {tabs, windows, mac, trailing, "\xef\xbb\xbf" + plain}) {
    const Molecule m = read(text).molecule;
    EXPECT_TRUE(m.positions == expected.positions);
    EXPECT_EQ(m.elements, expected.elements);
  }
}

}  // namespace
}  // namespace nanocarbon::molecule
