// SPDX-License-Identifier: GPL-2.0-or-later
// Text dumps of LAMMPS, by its documentation of dump and dump_modify.
#include <gmock/gmock.h>

#include "support/read_text.h"

namespace nanocarbon::molecule {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string dump(const std::string& columns, const std::string& atoms,
                 const std::string& box = "ITEM: BOX BOUNDS pp pp pp\n0 4\n0 5\n0 6\n") {
  return "ITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n2\n" + box + "ITEM: ATOMS " + columns + " \n" + atoms;
}
MoleculeFrame read(const std::string& text, const MoleculeReadOptions& options = {}) {
  return test::read_frames(text, "a.lammpstrj", options).at(0);
}
std::string error_of(const std::string& text, const MoleculeReadOptions& options = {}) {
  return test::error_of_text(text, "a.lammpstrj", options);
}

TEST(LammpsDumpReader, TakesPositionsOfEveryKind) {
  const std::string box = "ITEM: BOX BOUNDS pp pp pp\n-1 3\n0 5\n0 6\n";
  for (const auto& [columns, first] : std::vector<std::pair<std::string, std::string>>{
           {"id element x y z", "1 C 1 2.5 3"},
           {"element id xu yu zu", "C 1 1 2.5 3"},
           {"id xs ys zs element", "1 0.5 0.5 0.5 C"},
           {"id element xsu ysu zsu", "1 C 0.5 0.5 0.5"},
           {"id element x y z ix iy iz", "1 C -3 2.5 9 1 0 -1"},
           {"id element xs ys zs ix iy iz", "1 C 1.5 0.5 0.5 -1 0 0"},
           {"id mass x y z", "1 12.0107 1 2.5 3"}}) {
    std::string second = first;
    second.replace(second.find('1'), 1, "2");
    if (columns.starts_with("element")) second = "C 2 1 2.5 3";
    const MoleculeFrame frame = read(dump(columns, first + "\n" + second + "\n", box));
    EXPECT_EQ(frame.molecule.positions.at(0), Vec3(1, 2.5, 3)) << columns;
    EXPECT_THAT(frame.molecule.elements, testing::Each(Element::carbon));
    EXPECT_EQ(frame.step, 100);
  }
}

TEST(LammpsDumpReader, SortsByIdAndTakesBoundaries) {
  const MoleculeFrame frame =
      read(dump("id element x y z", "9 H 1 1 1\n4 C 2 2 2\n", "ITEM: BOX BOUNDS pp ff ss\n0 4\n0 5\n0 6\n"));
  EXPECT_THAT(frame.ids, ElementsAre(4, 9));
  EXPECT_THAT(frame.molecule.elements, ElementsAre(Element::carbon, Element::hydrogen));
  EXPECT_EQ(frame.molecule.cell->periodic, (std::array{true, false, false}));
  EXPECT_THAT(frame.warnings, ElementsAre());
  EXPECT_FALSE(
      read(dump("id element x y z", "1 C 1 1 1\n2 C 2 2 2\n", "ITEM: BOX BOUNDS ff ff ff\n0 4\n0 5\n0 6\n"))
          .molecule.cell);
  const MoleculeFrame old =
      read(dump("id element x y z", "1 C 1 1 1\n2 C 2 2 2\n", "ITEM: BOX BOUNDS\n0 4\n0 5\n0 6\n"));
  EXPECT_THAT(old.warnings, ElementsAre(HasSubstr("does not say which directions are periodic")));
}

// xlo_bound = xlo + MIN(0, xy, xz, xy + xz) and so on: LAMMPS's Howto_triclinic.
TEST(LammpsDumpReader, ReadsTiltedBoxes) {
  const MoleculeFrame tilted =
      read(dump("id element xs ys zs", "1 C 0 0 0\n2 C 0.5 0.5 0.5\n",
                "ITEM: BOX BOUNDS xy xz yz pp pp pp\n-2 5.5 -2\n-1 5 1.5\n0 6 -1\n"));
  ASSERT_TRUE(tilted.molecule.cell);
  const Mat3& m = tilted.molecule.cell->vectors;
  EXPECT_EQ(tilted.molecule.cell->origin, Vec3(0, 0, 0));
  EXPECT_EQ(m.col(0), Vec3(4, 0, 0));
  EXPECT_EQ(m.col(1), Vec3(-2, 5, 0));
  EXPECT_EQ(m.col(2), Vec3(1.5, -1, 6));
  EXPECT_EQ(tilted.molecule.positions[1], Vec3(0.5 * (4 - 2 + 1.5), 2, 3));
  const MoleculeFrame general =
      read(dump("id element x y z", "1 C 0 0 0\n2 C 1 1 1\n",
                "ITEM: BOX BOUNDS abc origin pp pp pp\n0 4 0 1\n-5 0 0 2\n0 0 6 3\n"));
  EXPECT_EQ(general.molecule.cell->vectors.col(1), Vec3(-5, 0, 0));
  EXPECT_EQ(general.molecule.cell->origin, Vec3(1, 2, 3));
}

TEST(LammpsDumpReader, GuessesNoElement) {
  const std::string types = dump("id type x y z", "1 1 1 1 1\n2 2 2 2 2\n");
  EXPECT_THAT(error_of(types), HasSubstr("a.lammpstrj:10: no column says what the atoms are"));
  EXPECT_THAT(read(types, {.types = {"C", "H"}}).molecule.elements,
              ElementsAre(Element::carbon, Element::hydrogen));
  EXPECT_THAT(error_of(types, {.types = {"C"}}), HasSubstr("--types does not say what type 2 is"));
  EXPECT_THAT(error_of(dump("id element x y z", "1 C 1 1 1\n2 Au 2 2 2\n")), HasSubstr("gold"));
  EXPECT_THAT(error_of(dump("id mass x y z", "1 12.011 1 1 1\n2 1 2 2 2\n")),
              HasSubstr("no element has a mass of"));
  // LAMMPS calls all types C where dump_modify element does not say otherwise.
  const std::string unnamed = dump("id type element x y z", "1 1 C 1 1 1\n2 2 C 2 2 2\n");
  EXPECT_THAT(read(unnamed).warnings, ElementsAre(HasSubstr("dump_modify element")));
  EXPECT_THAT(read(unnamed, {.types = {"C", "C"}}).warnings, ElementsAre());
}

// As dump_modify types labels has them.
TEST(LammpsDumpReader, TakesLabelsInTheColumnOfTypes) {
  const std::string labels = dump("id type x y z", "1 C_top 1 1 1\n2 H 2 2 2\n");
  EXPECT_THAT(read(labels).molecule.elements, ElementsAre(Element::carbon, Element::hydrogen));
  const std::string own_names = dump("id type x y z", "1 CA 1 1 1\n2 CA 2 2 2\n");
  EXPECT_THAT(error_of(own_names), HasSubstr("--types CA=C"));
  EXPECT_THAT(read(own_names, {.types = {"CA=C"}}).molecule.elements, testing::Each(Element::carbon));
}

TEST(LammpsDumpReader, ErrorsNameFileAndLine) {
  EXPECT_THAT(error_of(dump("id element x y z", "1 C 1 1 1\n2 C 2 2\n")),
              HasSubstr("a.lammpstrj:11: expected 5 columns"));
  EXPECT_THAT(error_of(dump("id element x y z", "1 C 1 1 1\n1 C 2 2 2\n")),
              HasSubstr("more than one has the ID 1"));
  EXPECT_THAT(error_of(dump("id element x y", "1 C 1 1\n2 C 2 2\n")), HasSubstr("no columns hold positions"));
  EXPECT_THAT(error_of("ITEM: UNITS\nlj\n" + dump("id element x y z", "1 C 1 1 1\n2 C 2 2 2\n")),
              HasSubstr("units lj"));
  EXPECT_THAT(error_of("ITEM: UNITS\nmetal\nITEM: TIME\n0.5\n" + dump("id element x y z", "1 C 1 1 1\n")),
              HasSubstr("the last frame is not whole"));
}

// As dump yaml writes them.
std::string yaml(const std::string& columns, const std::string& atoms, const std::string& more = "") {
  return "---\ncreator: LAMMPS\ntimestep: 100\nnatoms: 2\nboundary: [ p, p, f, f, s, s, ]\n" + more +
         "box:\n  - [ 0, 4 ]\n  - [ 0, 5 ]\n  - [ 0, 6 ]\nkeywords: [ " + columns + "  ]\ndata:\n" + atoms;
}

TEST(LammpsYamlReader, TakesWhatOtherDumpsHave) {
  const std::string text = yaml("id, type, 'c_pe[1]', x, y, z, ",
                                "  - [ 2 , 2 , -3 , 1 , 1 , 1 , ]\n  - [ 1 , 1 , -7 , 2 , 2.5 , 3 , ]\n...\n",
                                "thermo:\n  - keywords: [ Step, Temp, ]\n  - data: [ 100, 300, ]\n");
  const std::vector<MoleculeFrame> frames = test::read_frames(text + text, "a.yaml", {.types = {"C", "H"}});
  ASSERT_EQ(frames.size(), 2u);
  for (const MoleculeFrame& frame : frames) {
    EXPECT_EQ(frame.step, 100);
    EXPECT_THAT(frame.ids, ElementsAre(1, 2));
    EXPECT_THAT(frame.molecule.elements, ElementsAre(Element::carbon, Element::hydrogen));
    EXPECT_EQ(frame.molecule.positions[0], Vec3(2, 2.5, 3));
    EXPECT_EQ(frame.molecule.cell->periodic, (std::array{true, false, false}));
    EXPECT_THAT(frame.warnings, ElementsAre());
  }
}

TEST(LammpsYamlReader, ErrorsNameFileAndLine) {
  const auto error = [](const std::string& text) { return test::error_of_text(text, "a.yaml", {}); };
  const std::string one = "  - [ 1 , C , 1 , 1 , 1 , ]\n", columns = "id, element, x, y, z, ";
  EXPECT_THAT(error(yaml(columns, one)), HasSubstr("the file ends before atom 2 of 2"));
  EXPECT_THAT(error(yaml(columns, one + "  - [ 2 , C , 1 , 1 , ]\n")),
              HasSubstr("a.yaml:13: expected 5 columns"));
  EXPECT_THAT(error(yaml(columns, one + "---\n")), HasSubstr("a.yaml:13: expected a line - [ ... ]"));
  EXPECT_THAT(error(yaml(columns, one + one, "units: lj\n")), HasSubstr("a.yaml:6: the dump has units lj"));
  EXPECT_THAT(error(yaml("id, type, x, y, z, ", "  - [ 1 , 1 , 1 , 1 , 1 , ]\n")),
              HasSubstr("or --types C H"));
  EXPECT_THAT(error("---\nnatoms: 2\nkeywords: [ x, y, z ]\ndata:\n"), HasSubstr("there is no box"));
}

}  // namespace
}  // namespace nanocarbon::molecule
