// SPDX-License-Identifier: GPL-2.0-or-later
// The front door: which format a file is of, which of its frames is meant, and what is said of it.
#include "nanocarbon/molecule/formats/read_molecule.h"

#include <gmock/gmock.h>
#include <zlib.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "nanocarbon/molecule/formats/lammps_data.h"
#include "nanocarbon/molecule/formats/xyz.h"
#include "nanocarbon/structures/fullerene.h"
#include "support/read_text.h"
#include "support/temporary_folder.h"

namespace nanocarbon::molecule {
namespace {

using test::error_of_text;
using test::read_text;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string xyz = "2\n\nC 0 0 0\nC 0 0 1.4\n";
const std::string data =
    "title\n\n2 atoms\n1 atom types\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n\nMasses\n\n1 12.011\n\nAtoms # "
    "atomic\n\n"
    "1 1 0 0 0\n2 1 0 0 1.4\n";
std::string dump_frame(int step, const std::string& atoms) {
  return "ITEM: TIMESTEP\n" + std::to_string(step) +
         "\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp ff\n0 9\n0 9\n0 9\nITEM: ATOMS id element x y "
         "z\n" +
         atoms;
}
const std::string dump = dump_frame(0, "1 C 0 0 0\n2 C 0 0 1.4\n");
const std::string yaml =
    "---\ncreator: LAMMPS\ntimestep: 0\nnatoms: 2\nboundary: [ p, p, p, p, f, f, ]\nbox:\n  - [ 0, 9 ]\n  - "
    "[ 0, 9 ]\n"
    "  - [ 0, 9 ]\nkeywords: [ id, element, x, y, z,  ]\ndata:\n  - [ 1 , C , 0 , 0 , 0 , ]\n  - [ 2 , C , 0 "
    ", 0 , 1.4 , ]\n"
    "...\n";
const std::string poscar = "C\n1.0\n9 0 0\n0 9 0\n0 0 9\nC\n2\nCartesian\n0 0 0\n0 0 1.4\n";
const std::string cif =
    "data_c2\n_cell_length_a 9\n_cell_length_b 9\n_cell_length_c 10\n_cell_angle_alpha 90\n_cell_angle_beta "
    "90\n"
    "_cell_angle_gamma 90\n_space_group_name_H-M_alt 'P 1'\nloop_\n_atom_site_label\n_atom_site_type_symbol\n"
    "_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\nC1 C 0 0 0\nC2 C 0 0 0.14\n";

void pack(const std::filesystem::path& path, const std::string& text) {
  gzFile file = gzopen(path.c_str(), "wb");
  gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
}

TEST(ReadMolecule, TellsTheFormatByWhatTheFileHolds) {
  const std::vector<std::pair<MoleculeFormat, std::string>> texts = {
      {MoleculeFormat::xyz, xyz},          {MoleculeFormat::lammps_data, data},
      {MoleculeFormat::lammps_dump, dump}, {MoleculeFormat::lammps_yaml, yaml},
      {MoleculeFormat::poscar, poscar},    {MoleculeFormat::cif, cif}};
  const test::TemporaryFolder folder;
  for (const auto& [format, text] : texts)
    for (const std::string file :
         {"a.data", "data.graphene", "x.dat", "x.data2", "x.lmpdat", "b.xyz", "POSCAR", "c"}) {
      EXPECT_EQ(MoleculeFile(text, file).format(), format) << file;
      EXPECT_NEAR((read_text(text, file).molecule.positions.at(1) - Vec3(0, 0, 1.4)).norm(), 0.0, 1e-12)
          << file;
      pack(folder / file, text);  // packed, whatever the name
      EXPECT_NEAR((read_molecule(folder / file).molecule.positions.at(1) - Vec3(0, 0, 1.4)).norm(), 0.0,
                  1e-12);
    }
}

// An energy as comment, and atoms by their numbers: five lines of numbers, as POSCAR begins.
TEST(ReadMolecule, TellsXyzOfNumbersFromPoscar) {
  for (const char* energy : {"-75.5", "75.5", "1"}) {
    const std::string numbers =
        std::string("5\n") + energy + "\n6 0 0 0\n1 0 0 1.1\n1 0 1 0\n1 1 0 0\n1 -1 0 0\n";
    EXPECT_EQ(MoleculeFile(numbers, "a").format(), MoleculeFormat::xyz);
    EXPECT_EQ(read_text(numbers, "a", {.types = {"6=C", "1=H"}}).molecule.size(), 5u);
    EXPECT_THAT(error_of_text(numbers, "a"), HasSubstr("a:3: the atom's name '6' is a number"));
  }
}

TEST(ReadMolecule, NamesTheKindsThatItDoesNotRead) {
  EXPECT_THAT(error_of_text("", "a.xyz"), HasSubstr("the file is empty"));
  EXPECT_THAT(error_of_text(std::string("\xff\xfe"
                                        "2\0",
                                        4),
                            "a.xyz"),
              HasSubstr("UTF-16"));
  EXPECT_THAT(error_of_text("BZh91AY", "a.xyz.bz2"), HasSubstr("bzip2"));
  EXPECT_THAT(error_of_text(std::string("abc\0def", 7), "a.data"), HasSubstr("binary"));
  EXPECT_THAT(error_of_text("HEADER\nATOM      1  C   MOL     1       0.000   0.000   0.000\n", "a.pdb"),
              HasSubstr("PDB"));
  EXPECT_THAT(error_of_text("CRYST1   10.000   10.000   10.000  90.00  90.00  90.00 P 1\n", "a"),
              HasSubstr("PDB"));
  EXPECT_THAT(error_of_text("- of UlmASE-Trajectory", "a.traj"),
              testing::AllOf(HasSubstr("a trajectory of ASE"), HasSubstr("-m ase convert FILE new.xyz")));
  EXPECT_THAT(error_of_text(std::string("SQLite format 3\0", 16), "a.db"), HasSubstr("database"));
  EXPECT_THAT(error_of_text("{\"1\": {\n \"cell\": {}}}\n", "a.json"), HasSubstr("JSON"));
  EXPECT_THAT(error_of_text("<?xml version=\"1.0\"?>\n<modeling>\n", "vasprun.xml"), HasSubstr("XML"));
  EXPECT_THAT(error_of_text(std::string("T\0\0\0CORD\0\0", 10), "a.dcd"), HasSubstr("DCD"));
  EXPECT_THAT(error_of_text(std::string("\xf6\xff\xff\xff\xff\xff\xff\xff"
                                        "DUMPCUSTOM\1\0",
                                        20),
                            "a.bin"),
              HasSubstr("binary2txt"));
  EXPECT_THAT(error_of_text("---\nkeywords: ['Step', 'Temp', ]\ndata:\n  - [0, 300, ]\n...\n", "log"),
              HasSubstr("begins with \"---\""));
  EXPECT_THAT(error_of_text("units metal\nread_data x.data\n", "in.graphene"), HasSubstr("LAMMPS script"));
  EXPECT_THAT(error_of_text("OFF\n3 1 0\n", "a.off"), HasSubstr("nanocarbon build"));
  const std::string vectors = "9 0 0\n0 9 0\n0 0 9\n", sites = "C 1\n0 0 0\nC 2\n0 0 1.4\n";
  EXPECT_THAT(error_of_text("title\n 0 3 2\n" + vectors + sites, "CONFIG"), HasSubstr("DL_POLY"));
  EXPECT_THAT(error_of_text("title\n 0 0\n" + sites + sites, "CONFIG"), HasSubstr("DL_POLY"));
  EXPECT_THAT(error_of_text("CRYSTAL\nPRIMVEC\n" + vectors + "PRIMCOORD\n1 1\n6 0 0 0\n", "a.xsf"),
              HasSubstr("XSF"));
  EXPECT_THAT(error_of_text("Number of particles = 2\nA = 1 Angstrom\n", "a.cfg"), HasSubstr("AtomEye"));
  EXPECT_THAT(error_of_text("&CONTROL\n/\nATOMIC_POSITIONS angstrom\nC 0 0 0\n", "a.in"),
              HasSubstr("Quantum ESPRESSO"));
  EXPECT_THAT(error_of_text("%BLOCK LATTICE_CART\n" + vectors + "%ENDBLOCK\n", "a.cell"),
              HasSubstr("CASTEP"));
  EXPECT_THAT(
      error_of_text("# C2\n\n2 atoms\n\nCoords\n\n1 0 0 0\n2 0 0 1.4\n\nTypes\n\n1 1\n2 1\n", "c2.txt"),
      HasSubstr("molecule file of LAMMPS"));
  EXPECT_THAT(error_of_text("!BIOSYM archive 3\nPBC=ON\n", "a.car"), HasSubstr("Materials Studio"));
  EXPECT_THAT(error_of_text("c2\n  Avogadro\n\n  2  1  0  0  0  0  0  0  0  0999 V2000\n", "a.mol"),
              HasSubstr("MOL or SDF"));
  EXPECT_THAT(error_of_text("&GLOBAL\n&END\n&FORCE_EVAL\n", "a.inp"), HasSubstr("CP2K"));
  EXPECT_THAT(error_of_text(" vasp.6.3.0 20Jan22 complex\n", "OUTCAR"), HasSubstr("OUTCAR"));
  EXPECT_THAT(error_of_text("version https://git-lfs.github.com/spec/v1\noid sha256:4d\nsize 9\n", "a.xyz"),
              HasSubstr("git lfs pull"));
  EXPECT_THAT(error_of_text("<!DOCTYPE html>\n<html>\n", "a.xyz"), HasSubstr("web page"));
  EXPECT_THAT(error_of_text("hello\n", "a.txt"), HasSubstr("begins with \"hello\""));
}

// The name helps where the contents are wrong: the first wrong line is shown.
TEST(ReadMolecule, ShowsTheFirstWrongLine) {
  EXPECT_THAT(error_of_text("two\n\nC 0 0 0\n", "a.xyz"), HasSubstr("a.xyz:1: expected the number of atoms"));
  EXPECT_THAT(error_of_text("2\n\nC 0 0 0\nC 0 0 1,4\n", "a"),
              HasSubstr("a:4: expected z (a finite number), found '1,4'"));
  EXPECT_THAT(error_of_text(dump.substr(0, dump.size() - 12), "a"), HasSubstr("the last frame is not whole"));
}

TEST(ReadMolecule, DamagedPackedFilesAreMalformed) {
  const test::TemporaryFolder folder;
  std::string many = "5000\n\n";
  for (int i = 0; i < 5000; ++i)
    many += "C " + std::to_string(i * 7919 % 10007) + " 0 " + std::to_string(i) + "\n";
  pack(folder / "a.xyz.gz", many);
  EXPECT_EQ(read_molecule(folder / "a.xyz.gz").molecule.size(), 5000u);
  std::string bytes = test::contents_of(folder / "a.xyz.gz");
  std::ofstream(folder / "short.xyz.gz", std::ios::binary) << bytes.substr(0, bytes.size() / 2);
  bytes[bytes.size() / 2] ^= 0x55;
  std::ofstream(folder / "bad.xyz.gz", std::ios::binary) << bytes;
  for (const char* name : {"short.xyz.gz", "bad.xyz.gz"}) try {
      read_molecule(folder / name);
      FAIL() << name;
    } catch (const UserError& error) {
      EXPECT_EQ(error.failure(), Failure::malformed) << error.what();
    }
}

TEST(ReadMolecule, TakesTheFrameAskedFor) {
  const std::string frames = dump_frame(0, "1 C 0 0 0\n2 C 0 0 1.4\n") +
                             dump_frame(10, "2 C 0 0 1.5\n1 C 0 0 0\n") +
                             dump_frame(20, "1 C 0 0 0\n2 C 0 0 1.6\n");
  const auto distance = [&](std::optional<std::int64_t> frame) {
    return read_text(frames, "a", {}, frame).molecule.positions[1].z();
  };
  EXPECT_EQ(distance({}), 1.4);
  EXPECT_EQ(distance(1), 1.4);
  EXPECT_EQ(distance(2), 1.5);
  EXPECT_EQ(distance(-1), 1.6);
  EXPECT_EQ(distance(-3), 1.4);
  EXPECT_EQ(read_text(frames, "a", {}, 2).step, 10);
  EXPECT_THAT(read_text(frames, "a").warnings, ElementsAre(HasSubstr("more frames")));
  EXPECT_THAT(read_text(frames, "a", {}, 1).warnings, ElementsAre());
  for (const std::int64_t none : {4, -4, 0}) EXPECT_THROW(distance(none), UserError) << none;
  EXPECT_EQ(test::read_frames(frames, "a").size(), 3u);
  EXPECT_EQ(test::read_frames(xyz + "\n" + xyz, "a").size(), 2u);
}

TEST(ReadMolecule, NamesAtomsOnTopOfEachOther) {
  EXPECT_THAT(read_text("3\n\nC 0 0 0\nC 0 0 1.4\nC 0 0.1 1.4\n", "a").warnings,
              ElementsAre(HasSubstr("atoms 2 and 3 are 0.1 Angstrom from each other")));
  // A box that ends where its atoms do.
  const std::string columns =
      "4\nLattice=\"5.680002 0 0 0 20 0 0 0 20\" pbc=\"T F F\" Properties=species:S:1:pos:R:3\n"
      "C 0 0 0\nC 1.42 0 0\nC 4.26 0 0\nC 5.68 0 0\n";
  EXPECT_THAT(read_text(columns, "a").warnings,
              ElementsAre(HasSubstr(
                  "atoms 1 and 4 are 2e-06 Angstrom from each other across the periodic boundary")));
  std::string heap = "5000\n\n";
  for (int i = 0; i < 5000; ++i) heap += "C 0 0 0\n";
  EXPECT_THROW(read_text(heap, "a"), UserError);
}

// Lengths in Bohr: of graphene and of benzene, whose C-H would be 2.06.
TEST(ReadMolecule, DoubtsAtomsWithoutNeighbours) {
  const auto benzene = [](double unit) {
    std::string text = "12\n\n";
    for (int k = 0; k < 12; ++k) {
      const double angle = k * M_PI / 3, radius = unit * (k < 6 ? 1.40 : 2.49);
      text += (k < 6 ? "C " : "H ") + std::to_string(radius * std::cos(angle)) + " " +
              std::to_string(radius * std::sin(angle)) + " 0\n";
    }
    return text;
  };
  EXPECT_THAT(read_text(benzene(1.0), "a").warnings, ElementsAre());
  EXPECT_THAT(read_text(benzene(1 / 0.529177), "a").warnings,
              ElementsAre(HasSubstr("none of 12 atoms are near enough to another for a bond")));
  // In nanometres they are on top of each other.
  EXPECT_THROW(read_text(benzene(0.1), "a"), UserError);
  // Bonds may lead through the boundary.
  EXPECT_THAT(
      read_text("8\nLattice=\"12 0 0 0 40 0 0 0 40\" pbc=\"T F F\"\nC 0 0 0\nC 1.5 0 0\nC 3 0 0\nC 4.5 0 0\n"
                "C 6 0 0\nC 7.5 0 0\nC 9 0 0\nC 10.5 0 0\n",
                "a")
          .warnings,
      ElementsAre());
}

// A flat sheet in the box of a script for two dimensions, or without room above it.
TEST(ReadMolecule, DoubtsCellsThinnerThanABond) {
  const std::string sheet =
      "2\nLattice=\"2.46 0 0 1.23 2.13 0 0 0 1\" PBC Properties=species:S:1:pos:R:3\nC 0 0 0\nC 1.23 0.71 "
      "0\n";
  std::string all = sheet, flat = sheet;
  all.replace(all.find("PBC"), 3, "pbc=\"T T T\"");
  flat.replace(flat.find("PBC"), 3, "pbc=\"T T F\"");
  EXPECT_THAT(read_text(all, "a").warnings,
              ElementsAre(testing::AllOf(HasSubstr("each atom is 1 Angstrom from its own image"),
                                         HasSubstr("--boundary 'p p f'"))));
  EXPECT_THAT(read_text(flat, "a").warnings, ElementsAre());
}

TEST(ReadMolecule, SaysWhichNamesInTheOptionsNoAtomHas) {
  EXPECT_THAT(read_text(xyz, "a", {.types = {"CA=C"}}).warnings,
              ElementsAre(HasSubstr("no atom has that name")));
  EXPECT_THAT(read_text(xyz, "a", {.types = {"C", "C"}}).warnings, ElementsAre(HasSubstr("was not needed")));
  EXPECT_THAT(error_of_text(xyz, "a", {.atom_style = "full"}),
              HasSubstr("--atom-style is for LAMMPS data files"));
}

// One C60 in every format and with every way of naming its atoms is the same atoms.
TEST(ReadMolecule, MoleculesWrittenByThisLibraryComeBack) {
  const Molecule c60 = structures::fullerene(1, 1);
  std::ostringstream as_xyz, as_data;
  write_xyz(as_xyz, c60);
  write_lammps_data(as_data, c60);
  for (const std::string& text : {as_xyz.str(), as_data.str()}) {
    const MoleculeFrame frame = read_text(text, "a");
    EXPECT_TRUE(frame.molecule.positions == c60.positions);
    EXPECT_FALSE(frame.molecule.cell);
    EXPECT_THAT(frame.warnings, ElementsAre());
  }
}

}  // namespace
}  // namespace nanocarbon::molecule
