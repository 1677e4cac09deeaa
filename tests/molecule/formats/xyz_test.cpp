// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/xyz.h"

#include <gmock/gmock.h>

#include <sstream>

#include "molecule/shapes.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/dual.h"

namespace nanocarbon::molecule {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<Molecule> read(const std::string& text) {
  std::istringstream in(text);
  return read_xyz_frames(in, "test.xyz");
}

std::string error_of(const std::string& text) {
  try {
    read(text);
  } catch (const UserError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(Xyz, GivesBackWhatWasWritten) {
  Molecule molecule = dual(test::scaled_to_carbon(test::icosahedron()));
  molecule.elements[3] = Element::hydrogen;
  for (const bool in_cell : {false, true}) {
    if (in_cell) {
      molecule.cell = orthogonal_cell(Vec3(20, 21, 22), {true, false, true});
      molecule.cell->vectors(0, 2) = -1.0 / 3.0;
      molecule.cell->origin = Vec3(-1, 0.1, 0);
    }
    std::ostringstream out;
    write_xyz(out, molecule, "nanocarbon \"1\" make");
    const std::vector<Molecule> frames = read(out.str() + out.str());
    ASSERT_EQ(frames.size(), 2u);
    EXPECT_TRUE(frames[1].positions == molecule.positions);
    EXPECT_EQ(frames[1].elements, molecule.elements);
    ASSERT_EQ(frames[1].cell.has_value(), in_cell);
    if (in_cell) {
      EXPECT_EQ(frames[1].cell->vectors, molecule.cell->vectors);
      EXPECT_EQ(frames[1].cell->origin, molecule.cell->origin);
      EXPECT_EQ(frames[1].cell->periodic, molecule.cell->periodic);
    }
  }
}

// A propane skeleton: the middle atom has two bonds, the ends one each.
TEST(Xyz, NamesTheBondedAtoms) {
  Molecule molecule;
  molecule.positions = {{0, 0, 0}, {1.5, 0, 0}, {2, 1.4, 0}};
  molecule.elements.assign(3, Element::carbon);
  molecule.bonds = {{0, 1}, {1, 2}};
  std::ostringstream out;
  write_xyz(out, molecule);
  EXPECT_EQ(out.str(),
            "3\nProperties=species:S:1:pos:R:3:bonded:I:2 pbc=\"F F F\"\n"
            "C 0 0 0 2 0\nC 1.5 0 0 1 3\nC 2 1.4 0 2 0\n");
}

TEST(Xyz, ReadsPlainFiles) {
  const Molecule m = read("2\r\na comment = with \"words\r\nC 0 0 0\r\n H\t1.09e0 +1 -0.5 extra\r\n\n").at(0);
  EXPECT_THAT(m.elements, ElementsAre(Element::carbon, Element::hydrogen));
  EXPECT_EQ(m.positions[1], Vec3(1.09, 1, -0.5));
  EXPECT_FALSE(m.cell);
}

TEST(Xyz, FindsItsColumnsByProperties) {
  const Molecule m = read(
                         "1\nProperties=id:I:1:pos:R:3:species:S:1:forces:R:3 Lattice='5 0 0 0 5 0 0 0 5'\n"
                         "17 1 2 3 C 0 0 0\n")
                         .at(0);
  EXPECT_EQ(m.positions[0], Vec3(1, 2, 3));
  EXPECT_EQ(m.cell->periodic, (std::array{true, true, true}));
}

TEST(Xyz, CompletesAFlatSheetsCellAsAseWritesIt) {
  const Molecule m =
      read("1\nLattice=\"2.46 0.0 0.0 -1.23 2.13 0.0 0.0 0.0 0.0\" pbc=\"T T F\"\nC 0 0 0\n").at(0);
  EXPECT_NEAR((m.cell->vectors.col(2) - Vec3(0, 0, 1)).norm(), 0.0, 1e-12);
}

TEST(Xyz, ErrorsNameFileAndLine) {
  EXPECT_THAT(error_of("2\n\nC 0 0 0\n"), HasSubstr("test.xyz:3: the file ends after 1 of 2 atoms"));
  EXPECT_THAT(error_of("1\n\nSi 0 0 0\n"), HasSubstr("test.xyz:3: expected C or H, found 'Si'"));
  EXPECT_THAT(error_of("1\n\nC 0 inf 0\n"), HasSubstr("a finite number"));
  EXPECT_THAT(error_of("many\n\nC 0 0 0\n"), HasSubstr("test.xyz:1: "));
  EXPECT_THAT(error_of("-1\n\n"), HasSubstr("there cannot be -1 atoms"));
  EXPECT_THAT(error_of("1\nLattice=\"1 0 0 0 1 0\"\nC 0 0 0\n"), HasSubstr("must have 9 numbers"));
  EXPECT_THAT(error_of("1\nLattice=\"1 0 0 0 1 0 1 1 0\"\nC 0 0 0\n"), HasSubstr("do not span a volume"));
  EXPECT_THAT(error_of("1\nProperties=pos:R:3\n0 0 0\n"), HasSubstr("Properties must have species"));
  EXPECT_THAT(error_of(""), HasSubstr("the file is empty"));
}

}  // namespace
}  // namespace nanocarbon::molecule
