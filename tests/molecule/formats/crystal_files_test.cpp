// SPDX-License-Identifier: GPL-2.0-or-later
// CIF and POSCAR: unit cells with symmetry and fractions of their edges.
#include <gmock/gmock.h>

#include "nanocarbon/core/neighbours_within.h"
#include "support/read_text.h"

namespace nanocarbon::molecule {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

std::string cif(const std::string& cell, const std::string& symmetry, const std::string& atoms) {
  return "data_test\n" + cell + symmetry +
         "loop_\n_atom_site_label\n_atom_site_type_symbol\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_"
         "site_fract_z\n"
         "_atom_site_occupancy\n" +
         atoms;
}
std::string cell(double a, double b, double c, double alpha, double beta, double gamma) {
  return "_cell_length_a " + std::to_string(a) + "\n_cell_length_b " + std::to_string(b) +
         "(3)\n_cell_length_c " + std::to_string(c) + "\n_cell_angle_alpha " + std::to_string(alpha) +
         "\n_cell_angle_beta " + std::to_string(beta) + "\n_cell_angle_gamma " + std::to_string(gamma) + "\n";
}
MoleculeFrame read(const std::string& text, const MoleculeReadOptions& options = {}) {
  return test::read_frames(text, "test", options).at(0);
}
std::string error_of(const std::string& text, const MoleculeReadOptions& options = {}) {
  return test::error_of_text(text, "test", options);
}
// Neighbours of each atom within 1.7 Angstrom.
std::vector<std::size_t> neighbours(const Molecule& m) {
  const NeighbourList list = neighbours_within(m.positions, &*m.cell, 1.7);
  std::vector<std::size_t> counts;
  for (std::size_t i = 0; i < m.size(); ++i) counts.push_back(list.of(i).size());
  return counts;
}

// Diamond: 8 atoms in a cubic cell of 3.567 Angstrom, from one by Fd-3m (origin choices 1 and 2), four neighbours each.
TEST(CrystalFiles, DiamondFromOneAtomAndItsSpaceGroup) {
  const std::string cubic = cell(3.567, 3.567, 3.567, 90, 90, 90);
  for (const auto& [group, atom] : std::vector<std::pair<std::string, std::string>>{
           {"_space_group_name_H-M_alt 'F d -3 m :1'\n", "C1 C 0 0 0 1\n"},
           {"_symmetry_space_group_name_H-M 'F d -3 m :2'\n", "C1 C 0.125 0.125 0.125 1\n"},
           {"_space_group_name_Hall 'F 4d 2 3 -1d'\n", "C1 C 0 0 0 1\n"}}) {
    const MoleculeFrame frame = read(cif(cubic, group, atom));
    EXPECT_EQ(frame.molecule.size(), 8u) << group;
    EXPECT_THAT(neighbours(frame.molecule), Each(4u)) << group;
    EXPECT_THAT(frame.warnings, ElementsAre());
  }
}

// A name without its origin, or a number in place of a name, leaves open what the operations are.
TEST(CrystalFiles, GuessesNoOrigin) {
  const std::string cubic = cell(3.567, 3.567, 3.567, 90, 90, 90);
  for (const char* atom : {"C1 C 0 0 0 1\n", "C1 C 0.125 0.125 0.125 1\n"}) {
    EXPECT_THAT(error_of(cif(cubic, "_symmetry_space_group_name_H-M 'F d -3 m'\n", atom)),
                HasSubstr("two origins in use"));
    EXPECT_THAT(error_of(cif(cubic, "_symmetry_space_group_name_H-M '227'\n", atom)),
                HasSubstr("is not known"));
  }
  // Whether axes are hexagonal or rhombohedral is told by the angles: an atom at the origin is one of 3 or of 1.
  const std::string group = "_symmetry_space_group_name_H-M 'R -3 m'\n";
  EXPECT_EQ(read(cif(cell(5, 5, 9, 90, 90, 120), group, "C1 C 0 0 0 1\n")).molecule.size(), 3u);
  EXPECT_EQ(read(cif(cell(5, 5, 5, 70, 70, 70), group, "C1 C 0 0 0 1\n")).molecule.size(), 1u);
}

// A screw without an axis is no operation; whatever else is said of the group does not make up for it.
TEST(CrystalFiles, ScrewsOfAHallSymbolHaveAnAxis) {
  const std::string cubic = cell(5, 5, 5, 90, 90, 90);
  for (const char* hall : {"F 2d\"2 3 -1d", "P 2\"1", "P 2 12", "P 3*1", "P 2 2 11", "-"}) {
    const std::string group = std::string("_space_group_name_Hall '") + hall + "'\n";
    EXPECT_THAT(error_of(cif(cubic, group + "_space_group_name_H-M_alt 'P 1'\n", "C1 C 0 0 0 1\n")),
                HasSubstr("is not known"))
        << hall;
  }
  for (const auto& [hall, atoms] : std::vector<std::pair<std::string, std::size_t>>{
           {"P 41", 4}, {"P 21xa", 2}, {"-P 4n 2n (0 0 0)", 16}, {"P 31 2 (0 0 4)", 6}})
    EXPECT_EQ(read(cif(cell(5, 5, 5, 90, 90, hall[2] == '3' ? 120 : 90),
                       "_space_group_name_Hall '" + hall + "'\n", "C1 C 0.11 0.23 0.37 1\n"))
                  .molecule.size(),
              atoms)
        << hall;
}

// Graphite, P6_3/mmc by its listed operations and rounded thirds: 4 atoms with three neighbours each.
TEST(CrystalFiles, GraphiteByListedOperations) {
  const std::string operations =
      "loop_\n_space_group_symop_operation_xyz\n'x, y, z'\n'-y, x-y, z'\n'-x+y, -x, z'\n'-x, -y, z+1/2'\n"
      "'y, -x+y, z+1/2'\n'x-y, x, z+1/2'\n";
  const MoleculeFrame frame = read(cif(cell(2.464, 2.464, 6.711, 90, 90, 120), operations,
                                       "C1 C 0 0 0.25 1\nC2 C 0.3333 0.6667 0.25 1.0\n"));
  EXPECT_EQ(frame.molecule.size(), 4u);
  EXPECT_THAT(neighbours(frame.molecule), Each(3u));
}

TEST(CrystalFiles, CifSaysWhatIsWrong) {
  const std::string box = cell(5, 5, 5, 90, 90, 90), p1 = "_symmetry_space_group_name_H-M 'P 1'\n";
  EXPECT_THAT(error_of(cif(box, p1, "C1 C 0 0 0 0.5\n")), HasSubstr("'C1' has the occupancy 0.5"));
  EXPECT_THAT(error_of(cif(box, p1, "Au1 Au 0 0 0 1\n")), HasSubstr("gold"));
  EXPECT_THAT(error_of(cif(box, p1, "C1 C 0 ? 0 1\n")),
              HasSubstr("a coordinate of atom 'C1' must be a number"));
  EXPECT_THAT(error_of(cif(box, "_symmetry_space_group_name_H-M 'Z 9'\n", "C1 C 0 0 0 1\n")),
              HasSubstr("'Z 9' is not known"));
  EXPECT_THAT(error_of(cif(box, "_space_group_IT_number 227\n", "C1 C 0 0 0 1\n")),
              HasSubstr("by its number alone"));
  EXPECT_THAT(error_of(cif(cell(5, 5, 5, 90, 90, 181), p1, "C1 C 0 0 0 1\n")),
              HasSubstr("_cell_angle_gamma"));
  EXPECT_THAT(error_of(cif("", p1, "C1 C 0 0 0 1\n")), HasSubstr("_cell_length_a"));
  EXPECT_THAT(error_of(cif(box, p1, "C1 C 0 0\n")), HasSubstr("test:"));
  EXPECT_THAT(read(cif(box, "", "C1 C 0 0 0 1\n")).warnings,
              ElementsAre(HasSubstr("does not give its symmetry")));
}

TEST(CrystalFiles, PoscarOfEveryKind) {
  const std::string vectors = "2 0 0\n0 2 0\n0 0 4\n";
  for (const std::string& text :
       {"title\n2\n" + vectors + "C H\n1 1\nDirect\n0 0 0\n0.25 0.5 0.5\n",
        "title\n-128\n" + vectors + "C H\n1 1\nSelective dynamics\nDirect\n0 0 0 T T T\n0.25 0.5 0.5 F F F\n",
        "title\n2\n" + vectors + "C_GW H/ab12\n1 1\nCartesian\n0 0 0\n0.5 1 2\n\n0 0 0\n0 0 0\n"}) {
    const Molecule m = read(text).molecule;
    EXPECT_THAT(m.elements, ElementsAre(Element::carbon, Element::hydrogen));
    EXPECT_NEAR((m.positions[1] - Vec3(1, 2, 4)).norm(), 0.0, 1e-12) << text;
    EXPECT_NEAR((m.cell->vectors.diagonal() - Vec3(4, 4, 8)).norm(), 0.0, 1e-12);
  }
  const std::string old = "title\n1\n" + vectors + "1 1\nDirect\n0 0 0\n0.5 0.5 0.5\n";
  EXPECT_THAT(error_of(old), HasSubstr("test:6: the file does not name its elements"));
  EXPECT_THAT(read(old, {.types = {"C", "H"}}).molecule.elements,
              ElementsAre(Element::carbon, Element::hydrogen));
  EXPECT_THAT(error_of("t\n1\n" + vectors + "C\n2\nDirect\n0 0 0\n"),
              HasSubstr("the file ends before atom 2"));
  EXPECT_EQ(read("t\n1\n" + vectors + "C\n1\nFractional\n0.5 0 0\n").molecule.positions[0], Vec3(1, 0, 0));
  EXPECT_THAT(error_of("t\n1\n" + vectors + "C\n1\n0 0 0\n"), HasSubstr("expected Direct or Cartesian"));
}

// VASP 5 writes the head once, or before each configuration where the cell changes.
TEST(CrystalFiles, XdatcarHasFrames) {
  const auto head = [](const std::string& edge) {
    return "carbon and hydrogen\n 1\n " + edge + " 0 0\n 0 4 0\n 0 0 8\n C H\n 1 1\n";
  };
  const std::string first = "Direct configuration=     1\n 0 0 0\n 0.25 0.5 0.5\n",
                    second = "Direct configuration=    11\n 0 0 0\n 0.5 0.5 0.25\n";
  for (const bool changes : {false, true}) {
    const std::vector<MoleculeFrame> frames =
        test::read_frames(head("4") + first + (changes ? head("8") : "") + second, "XDATCAR");
    ASSERT_EQ(frames.size(), 2u);
    EXPECT_EQ(frames[0].step, 1);
    EXPECT_EQ(frames[1].step, 11);
    EXPECT_EQ(frames[0].molecule.positions[1], Vec3(1, 2, 4));
    EXPECT_EQ(frames[1].molecule.positions[1], Vec3(changes ? 4 : 2, 2, 2));
    EXPECT_EQ(frames[1].molecule.cell->vectors(0, 0), changes ? 8 : 4);
    EXPECT_THAT(frames[1].molecule.elements, ElementsAre(Element::carbon, Element::hydrogen));
  }
  EXPECT_THAT(error_of(head("4") + first + "\n0 0 0\n"), HasSubstr("expected Direct configuration="));
}

}  // namespace
}  // namespace nanocarbon::molecule
