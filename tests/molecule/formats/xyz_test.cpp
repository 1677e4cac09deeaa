// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/xyz.h"

#include <gmock/gmock.h>

#include <sstream>

#include "molecule/shapes.h"
#include "nanocarbon/molecule/dual.h"
#include "support/read_text.h"

namespace nanocarbon::molecule {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<Molecule> read(const std::string& text, const MoleculeReadOptions& options = {}) {
  std::vector<Molecule> molecules;
  for (MoleculeFrame& frame : test::read_frames(text, "test.xyz", options))
    molecules.push_back(std::move(frame.molecule));
  return molecules;
}

std::string error_of(const std::string& text, const MoleculeReadOptions& options = {}) {
  return test::error_of_text(text, "test.xyz", options);
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
  EXPECT_THAT(error_of("1\n\nSi 0 0 0\n"), HasSubstr("test.xyz:3: 'Si' is silicon (Si)"));
  EXPECT_THAT(error_of("1\n\nC 0 inf 0\n"), HasSubstr("a finite number"));
  EXPECT_THAT(error_of("many\n\nC 0 0 0\n"), HasSubstr("test.xyz:1: "));
  EXPECT_THAT(error_of("-1\n\n"), HasSubstr("there cannot be -1 atoms"));
  EXPECT_THAT(error_of("1\nLattice=\"1 0 0 0 1 0\"\nC 0 0 0\n"), HasSubstr("must have 9 values"));
  EXPECT_THAT(error_of("1\nLattice=\"1 0 0 0 1 0 1 1 0\"\nC 0 0 0\n"), HasSubstr("do not span a volume"));
  EXPECT_THAT(error_of("1\nProperties=pos:R:3\n0 0 0\n"), HasSubstr("Properties must have species"));
  EXPECT_THAT(error_of(""), HasSubstr("the file is empty"));
}

TEST(Xyz, TakesNamesThatLeaveNoDoubt) {
  for (const char* name :
       {"C", "c", "C1", "C60", "c12", "C_2", "C.ar", "C_R", "C1A", "C12H", "carbon", "Carbon"})
    EXPECT_THAT(read(std::string("1\n\n") + name + " 0 0 0\n").at(0).elements, ElementsAre(Element::carbon))
        << name;
  for (const char* name : {"H", "h", "H12", "D", "hydrogen"})
    EXPECT_THAT(read(std::string("1\n\n") + name + " 0 0 0\n").at(0).elements, ElementsAre(Element::hydrogen))
        << name;
  // Calcium, or a name for carbon; a builder's names; numbers.
  for (const char* name : {"CA", "ca", "CT", "HC", "CB1", "1", "6", "X", "CH2", "C2H6", "C10H22", "H2O"}) {
    const std::string text = std::string("1\n\n") + name + " 0 0 0\n";
    EXPECT_THAT(error_of(text),
                AllOf(HasSubstr("test.xyz:3: "), HasSubstr(std::string("--types ") + name + "=C")));
    EXPECT_THAT(read(text, {.types = {std::string(name) + "=C"}}).at(0).elements,
                ElementsAre(Element::carbon));
  }
  EXPECT_THAT(error_of("1\n\nCA 0 0 0\n"), HasSubstr("could be calcium"));
  EXPECT_THAT(error_of("1\n\nAu1 0 0 0\n"), HasSubstr("is gold (Au)"));
  EXPECT_THAT(read("2\n\n1 0 0 0\n2 0 0 1\n", {.types = {"C", "H"}}).at(0).elements,
              ElementsAre(Element::carbon, Element::hydrogen));
}

TEST(Xyz, ReadsAtomicNumbersWhereTheFileCallsThemSo) {
  const std::string text = "2\nProperties=Z:I:1:pos:R:3\n6 0 0 0\n1 0 0 1\n";
  EXPECT_THAT(read(text).at(0).elements, ElementsAre(Element::carbon, Element::hydrogen));
  EXPECT_THAT(error_of("1\nProperties=Z:I:1:pos:R:3\n79 0 0 0\n"), HasSubstr("gold"));
}

TEST(Xyz, ReadsFortransExponents) {
  EXPECT_EQ(read("1\n\nC 1.5D+00 -2.5d-1 +1E2\n").at(0).positions[0], Vec3(1.5, -0.25, 100));
}

TEST(Xyz, RefusesPeriodicityWithoutLattice) {
  const std::string text = "1\nProperties=species:S:1:pos:R:3 pbc=\"T T F\"\nC 0 0 0\n";
  EXPECT_THAT(error_of(text), AllOf(HasSubstr("test.xyz:2: "), HasSubstr("--boundary 'f f f'")));
  EXPECT_FALSE(read(text, {.periodic = std::array{false, false, false}}).at(0).cell);
  EXPECT_THAT(error_of("1\n\nC 0 0 0\n", {.periodic = std::array{true, true, false}}),
              HasSubstr("gives no cell"));
}

TEST(Xyz, RefusesAtomsBeyondTheNumberPromised) {
  EXPECT_THAT(error_of("1\n\nC 0 0 0\nC 0 0 2\n"),
              AllOf(HasSubstr("test.xyz:4: "), HasSubstr("ended with the 1 atoms that it promised")));
}

// As OVITO, GPUMD, QUIP and ASE write the comment line; the last with its newer, bracketed values.
TEST(Xyz, ReadsTheCommentLinesOfOtherPrograms) {
  for (const std::string comment :
       {"Lattice=\"4 0 0 0 5 0 0 0 6\" Origin=\"0 0 0\" Properties=species:S:1:pos:R:3",
        "pbc=\"T T T\" lattice=\"4 0 0 0 5 0 0 0 6\" properties=species:S:1:pos:R:3:mass:R:1:group:I:2",
        "Lattice=\"4 0 0 0 5 0 0 0 6\" Properties=species:S:1:pos:R:3:Z:I:1:force:R:3 pbc=[T, T, T] "
        "cutoff=-1",
        "Lattice=[[4, 0, 0], [0, 5, 0], [0, 0, 6]] Properties=species:S:1:pos:R:3 pbc=[true, true, true]"}) {
    const Molecule m = read("1\n" + comment + "\nC 1 2 3 6 0 0 0\n").at(0);
    ASSERT_TRUE(m.cell) << comment;
    EXPECT_EQ(m.cell->vectors, Mat3(Vec3(4, 5, 6).asDiagonal())) << comment;
    EXPECT_EQ(m.cell->periodic, (std::array{true, true, true})) << comment;
  }
}

// i-PI gives cell and units so; by default both are in Bohr.
TEST(Xyz, RefusesUnitsThatItDoesNotRead) {
  for (const char* comment :
       {"# CELL(abcABC): 20 20 20 90 90 90 Step: 0 Bead: 0 positions{atomic_unit} cell{atomic_unit}",
        "# CELL(GENH): 9 0 0 0 9 0 0 0 9 Step: 0 Bead: 0 x_centroid{angstrom}"})
    EXPECT_THAT(error_of(std::string("1\n") + comment + "\nC 0 0 0\n"),
                AllOf(HasSubstr("test.xyz:2: "), HasSubstr("i-PI"), HasSubstr("Lattice=")));
}

// ASE writes pbc="F F F" for atoms that were never told to be periodic.
TEST(Xyz, DoubtsOpenCellsThatBondsLeadThrough) {
  const auto warnings = [](const std::string& pbc, double height, const MoleculeReadOptions& options = {}) {
    std::string text =
        "8\nLattice=\"4.26 0 0 0 4.92 0 0 0 10\" Properties=species:S:1:pos:R:3 pbc=\"" + pbc + "\"\n";
    for (const double y : {0.0, 2.46})
      for (const auto& [x, dy] : {std::pair{0.0, 0.0}, {0.71, 1.23}, {2.13, 1.23}, {2.84, 0.0}})
        text += "C " + std::to_string(x) + " " + std::to_string(y + dy) + " " + std::to_string(height) + "\n";
    return test::read_frames(text, "a.xyz", options).at(0).warnings;
  };
  EXPECT_THAT(warnings("F F F", 5), testing::ElementsAre(AllOf(HasSubstr("bonds would lead through"),
                                                               HasSubstr("--boundary 'p p f'"))));
  EXPECT_THAT(warnings("T F F", 5), testing::ElementsAre(HasSubstr("--boundary 'p p f'")));
  EXPECT_THAT(warnings("F F F", -0.1), testing::ElementsAre(HasSubstr("--boundary 'p p f'")));
  EXPECT_THAT(warnings("T T F", 5), ElementsAre());
  EXPECT_THAT(warnings("T T T", 5), ElementsAre());
  EXPECT_THAT(warnings("F F F", 5, {.periodic = std::array{false, false, false}}), ElementsAre());
}

TEST(Xyz, SaysWhereNumbersStandBeforeNames) {
  EXPECT_THAT(error_of("1\n20 20 20 90 90 90\n1 C 0 0 0 2 3 4\n"),
              HasSubstr("a number stands before the name"));
}

TEST(Xyz, TurnsLeftHandedLatticesRound) {
  const Molecule m = read("1\nLattice=\"0 4 0 4 0 0 0 0 5\"\nC 1 2 3\n").at(0);
  EXPECT_GT(volume(*m.cell), 0.0);
  EXPECT_EQ(m.positions[0], Vec3(1, 2, 3));
}

TEST(Xyz, OrdersAtomsByTheirIdsWhereThoseTellThemApart) {
  const std::string start = "2\nProperties=species:S:1:pos:R:3:id:I:1\n";
  EXPECT_THAT(test::read_frames(start + "C 0 0 0 9\nH 0 0 1 4\n", "a.xyz").at(0).ids, ElementsAre(4, 9));
  EXPECT_THAT(test::read_frames(start + "C 0 0 0 7\nH 0 0 1 7\n", "a.xyz").at(0).ids, ElementsAre(1, 2));
}

}  // namespace
}  // namespace nanocarbon::molecule
