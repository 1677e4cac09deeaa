// SPDX-License-Identifier: GPL-2.0-or-later
// What ASE reads from our files, and what we read from ASE's.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <Eigen/LU>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "molecule/shapes.h"
#include "nanocarbon/molecule/dual.h"
#include "nanocarbon/molecule/formats/lammps_data.h"
#include "nanocarbon/molecule/formats/read_molecule.h"
#include "nanocarbon/molecule/formats/xyz.h"
#include "support/temporary_folder.h"

namespace nanocarbon::molecule {
namespace {

namespace fs = std::filesystem;

class AseReads : public testing::Test {
 protected:
  void SetUp() override {
    if (std::string(NANOCARBON_ASE_PYTHON).empty())
      GTEST_SKIP() << "no Python with ASE was found (python3-ase)";
    molecule = dual(test::scaled_to_carbon(test::icosahedron()));
    molecule.elements[7] = Element::hydrogen;
  }

  void run(const std::string& arguments) const {
    const std::string command = fmt::format("\"{}\" \"{}\" {} > \"{}\"", NANOCARBON_ASE_PYTHON,
                                            NANOCARBON_ASE_SCRIPT, arguments, (folder / "seen").string());
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
  }

  // What ASE printed must be the molecule with its positions moved and in the given cell.
  void expect_seen(const std::string& pbc, const Mat3* vectors, bool with_bonds = false) const {
    std::ifstream seen(folder / "seen");
    std::string count, symbols, periodic;
    std::getline(seen, count);
    std::getline(seen, symbols);
    std::getline(seen, periodic);
    EXPECT_EQ(count, "20");
    EXPECT_EQ(symbols, "CCCCCCCHCCCCCCCCCCCC");
    EXPECT_EQ(periodic, pbc);
    for (int k = 0; k < 9; ++k) {
      double x = 0.0;
      seen >> x;
      if (vectors) {
        EXPECT_NEAR(x, (*vectors)(k % 3, k / 3), 1e-12) << k;
      }
    }
    for (const Vec3& p : molecule.positions)
      for (int d = 0; d < 3; ++d) {
        double x = 0.0;
        ASSERT_TRUE(seen >> x);
        EXPECT_NEAR(x, p[d], 1e-12);
      }
    std::vector<Bond> bonds;
    for (AtomIndex i = 0; i < molecule.size(); ++i)
      for (AtomIndex k = 0, other = 0; k < 3 && seen >> other; ++k)
        if (i + 1 < other) bonds.push_back({i, other - 1});
    std::sort(bonds.begin(), bonds.end());
    if (with_bonds) {
      EXPECT_EQ(bonds, molecule.bonds);
    }
  }

  const test::TemporaryFolder temporary;
  const fs::path folder = temporary.path();
  Molecule molecule;
};

TEST_F(AseReads, OurXyz) {
  const fs::path file = folder / "a.xyz";
  write_xyz(file, molecule, "nanocarbon 0 make \"x\"");
  run(fmt::format("xyz \"{}\"", file.string()));
  expect_seen("0 0 0", nullptr, true);

  molecule.cell = orthogonal_cell(Vec3(20, 21, 22), {true, false, true});
  molecule.cell->vectors(0, 1) = 0.25;
  write_xyz(file, molecule);
  run(fmt::format("xyz \"{}\"", file.string()));
  expect_seen("1 0 1", &molecule.cell->vectors, true);
}

TEST_F(AseReads, OurDataFilesOfEveryStyle) {
  for (const AtomStyle style :
       {AtomStyle::atomic, AtomStyle::charge, AtomStyle::molecular, AtomStyle::full}) {
    const fs::path file = folder / "a.data";
    LammpsDataOptions options;
    options.atom_style = style;
    options.comment = "nanocarbon 0 build Atoms.off";
    write_lammps_data(file, molecule, options);
    run(fmt::format("data \"{}\" {}", file.string(), name(style)));
    expect_seen("1 1 1", nullptr);  // ASE takes every data file as periodic
  }
}

TEST_F(AseReads, OurPeriodicDataFiles) {
  molecule.cell = orthogonal_cell(Vec3(20, 21, 22));
  molecule.cell->origin = Vec3(-10, -10, -10);
  molecule.cell->vectors(0, 2) = 3.0;
  const fs::path file = folder / "a.data";
  write_lammps_data(file, molecule);
  run(fmt::format("data \"{}\" atomic", file.string()));
  expect_seen("1 1 1", &molecule.cell->vectors);
}

TEST_F(AseReads, AndWritesDataThatWeRead) {
  molecule.cell = orthogonal_cell(Vec3(20, 21, 22));
  molecule.cell->vectors(0, 1) = 2.0;
  write_xyz(folder / "a.xyz", molecule);
  run(fmt::format("convert \"{}\" \"{}\"", (folder / "a.xyz").string(), (folder / "b.data").string()));
  const Molecule back = read_molecule(folder / "b.data", {.types = {"C", "H"}}).molecule;
  EXPECT_EQ(back.elements, molecule.elements);
  EXPECT_NEAR((back.cell->vectors - molecule.cell->vectors).norm(), 0.0, 1e-9);
  for (std::size_t i = 0; i < molecule.size(); ++i) {
    // ASE may wrap atoms into the cell.
    const Vec3 f = molecule.cell->vectors.inverse() * (back.positions[i] - molecule.positions[i]);
    EXPECT_NEAR((f - f.array().round().matrix()).norm(), 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace nanocarbon::molecule
