// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>

#include <fstream>
#include <random>
#include <sstream>

#include "molecule/shapes.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/bond_statistics.h"
#include "nanocarbon/molecule/dual.h"
#include "nanocarbon/molecule/formats/lammps_data.h"
#include "nanocarbon/topology/bond_graph.h"

namespace nanocarbon::molecule {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

LammpsData read(const std::string& text, const LammpsReadOptions& options = {}) {
  std::istringstream in(text);
  return read_lammps_data(in, "test.data", options);
}

LammpsData written_and_read(const Molecule& molecule, AtomStyle style) {
  std::ostringstream out;
  LammpsDataOptions options;
  options.atom_style = style;
  write_lammps_data(out, molecule, options);
  return read(out.str());
}

std::string error_of(const std::string& text, const LammpsReadOptions& options = {}) {
  try {
    read(text, options);
  } catch (const UserError& error) {
    return error.what();
  }
  return "nothing was thrown";
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
  const LammpsData data = read(by_write_data);
  EXPECT_EQ(data.atom_style, AtomStyle::molecular);
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
  const LammpsData data = read(
      "ch.data (written by ASE) \n\n2 \t atoms \n2  atom types\n0.0      2.5  xlo xhi\n0.0      4.0  ylo "
      "yhi\n"
      "0.0      9.0  zlo zhi\n      1.25       0       0  xy xz yz\n\n\nAtoms \n\n"
      "     1   1        0  1  2\n     2   2      1.5    1    2\n");
  EXPECT_EQ(data.atom_style, AtomStyle::atomic);
  EXPECT_THAT(data.molecule.elements, ElementsAre(Element::carbon, Element::hydrogen));
  EXPECT_EQ(data.molecule.cell->vectors(0, 1), 1.25);
}

TEST(LammpsDataReader, GivesBackWhatTheWriterWrote) {
  const Molecule molecule = dual(test::scaled_to_carbon(test::sqrt3_subdivided_sphere(test::icosahedron())));
  for (const AtomStyle style :
       {AtomStyle::atomic, AtomStyle::charge, AtomStyle::molecular, AtomStyle::full}) {
    const LammpsData data = written_and_read(molecule, style);
    EXPECT_EQ(data.atom_style, style);
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
  const LammpsData data = read(
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
  EXPECT_THAT(error_of(text), HasSubstr("neither carbon nor hydrogen"));
  LammpsReadOptions options;
  options.type_elements = {Element::carbon};
  options.periodic = {false, false, false};
  const LammpsData data = read(text, options);
  EXPECT_THAT(data.molecule.elements, testing::Each(Element::carbon));
  EXPECT_FALSE(data.molecule.cell);
}

TEST(LammpsDataReader, ErrorsNameFileAndLine) {
  EXPECT_THAT(error_of(head + "Atoms # atomic\n\n1 1 0 0 0\n2 1 0 zero 0\n"), HasSubstr("test.data:13: "));
  EXPECT_THAT(error_of(head + "Atoms # atomic\n\n1 1 0 0 0\n2 1 0 0\n"),
              HasSubstr("test.data:13: expected 5 or 8"));
  EXPECT_THAT(error_of(head + "Atoms # atomic\n\n1 1 0 0 0\n"), HasSubstr("the header says 2 atoms"));
  EXPECT_THAT(error_of(head + "Atoms # atomic\n\n1 1 0 0 0\n1 1 0 0 nan\n"), HasSubstr("a finite number"));
  EXPECT_THAT(error_of(head + "Atoms # atomic\n\n7 1 0 0 0\n7 1 0 0 2\n"),
              HasSubstr("already used on line 12"));
  EXPECT_THAT(error_of(head + "Atoms # atomic\n\n1 1 0 0 0\n2 5 0 0 2\n"), HasSubstr("'5' is not one of"));
  EXPECT_THAT(error_of(head + "Atoms # ellipsoid\n\n1 1 0 0 0\n2 1 0 0 2\n"),
              HasSubstr("'ellipsoid' is not supported"));
  EXPECT_THAT(error_of(head + "Atoms\n\n1 1 1 0 0 0\n2 1 1 0 0 2\n\nBonds\n\n1 1 1 3\n"),
              HasSubstr("test.data:17: "));
  EXPECT_THAT(error_of("x\n\n1 atoms\n\nAtoms\n\n1 1 0 0 0\n"), HasSubstr("does not give a box"));
  EXPECT_THAT(error_of(head), HasSubstr("no Atoms section"));
  EXPECT_THAT(error_of(""), HasSubstr("no Atoms section"));
  EXPECT_THAT(error_of(head + "Atoms\n\n1 1 0 0\n2 1 0 0\n"), HasSubstr("no known style"));
}

TEST(LammpsDataReader, AMissingFileIsUnreadable) {
  try {
    read_lammps_data("/nowhere/at-all.data");
    FAIL() << "nothing was thrown";
  } catch (const UserError& error) {
    EXPECT_EQ(error.failure(), Failure::unreadable);
  }
}

}  // namespace
}  // namespace nanocarbon::molecule
