// SPDX-License-Identifier: GPL-2.0-or-later
// What LAMMPS makes of our data files, and what we read from those it writes.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "molecule/shapes.h"
#include "nanocarbon/molecule/bond_statistics.h"
#include "nanocarbon/molecule/dual.h"
#include "nanocarbon/molecule/formats/lammps_data.h"
#include "nanocarbon/molecule/formats/read_molecule.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/tube.h"
#include "nanocarbon/topology/bond_graph.h"
#include "support/temporary_folder.h"

namespace nanocarbon::molecule {
namespace {

namespace fs = std::filesystem;

class LammpsReads : public testing::Test {
 protected:
  void SetUp() override {
    if (std::string(NANOCARBON_LMP).empty()) GTEST_SKIP() << "no LAMMPS program lmp was found";
  }

  // Energy in eV that LAMMPS's REBO gives for a.data; it also writes what it read as b.data.
  double energy(AtomStyle style, const std::string& boundary) {
    {
      std::ofstream in(folder / "in.lammps");
      in << "units metal\natom_style " << name(style) << "\nboundary " << boundary << "\nread_data a.data\n";
      if (has_bonds(style)) in << "special_bonds lj/coul 1 1 1\n";
      const bool debian = fs::exists("/usr/share/lammps/potentials/CH.rebo");
      in << "pair_style rebo\npair_coeff * * " << (debian ? "/usr/share/lammps/potentials/" : "")
         << "CH.rebo C H\n"
         << "run 0\nvariable energy equal pe\nprint \"${energy}\" file energy\nwrite_data b.data\n";
    }
    const std::string command = fmt::format("cd \"{}\" && \"{}\" -in in.lammps -log log.lammps > screen 2>&1",
                                            folder.string(), NANOCARBON_LMP);
    if (std::system(command.c_str()) != 0) {
      std::ifstream screen(folder / "screen");
      ADD_FAILURE() << command << "\n" << std::string(std::istreambuf_iterator<char>(screen), {});
      return 0.0;
    }
    std::ifstream energy(folder / "energy");
    double value = 0.0;
    energy >> value;
    return value;
  }

  void write(const Molecule& molecule, AtomStyle style) {
    LammpsDataOptions options;
    options.atom_style = style;
    options.comment = "nanocarbon test";
    write_lammps_data(folder / "a.data", molecule, options);
  }

  // b.data must hold the molecule's bonds, or without Bonds section the same distances; lengths as exact as
  // LAMMPS writes them.
  void expect_read_back(const Molecule& molecule, AtomStyle style) {
    MoleculeReadOptions options;
    if (!molecule.cell) options.periodic = {false, false, false};
    MoleculeFrame data = read_molecule(folder / "b.data", options);
    ASSERT_EQ(data.molecule.size(), molecule.size());
    EXPECT_EQ(data.molecule.elements, molecule.elements);
    Molecule& back = data.molecule;
    if (!has_bonds(style))
      back.bonds = topology::bonds_within(back.positions, back.elements, back.cell ? &*back.cell : nullptr);
    ASSERT_TRUE(topology::bonded_ids(back.bonds) == topology::bonded_ids(molecule.bonds));
    const auto before = bond_lengths(molecule), after = bond_lengths(back);
    for (std::size_t b = 0; b < before.size(); ++b) EXPECT_NEAR(before[b], after[b], 1e-9);
  }

  const test::TemporaryFolder temporary;
  const fs::path folder = temporary.path();
};

TEST_F(LammpsReads, EveryAtomStyleWithTheSameEnergy) {
  const Molecule c60 = structures::fullerene(1, 1);
  double first = 0.0;
  for (const AtomStyle style :
       {AtomStyle::atomic, AtomStyle::charge, AtomStyle::molecular, AtomStyle::full}) {
    write(c60, style);
    const double e = energy(style, "f f f");
    if (style == AtomStyle::atomic) first = e;
    EXPECT_LT(e, -6.5 * 60);  // REBO2's C60 has about -6.8 eV per atom at its minimum
    EXPECT_NEAR(e, first, 1e-9);
    expect_read_back(c60, style);
  }
}

TEST_F(LammpsReads, PeriodicGrapheneInRectangularAndObliqueCells) {
  // REBO2's graphene: -7.395 eV per atom (D. W. Brenner et al., J. Phys.: Condens. Matter 14, 783 (2002)).
  const Molecule rectangle = structures::graphene(3, 2);
  write(rectangle, AtomStyle::molecular);
  EXPECT_NEAR(energy(AtomStyle::molecular, "p p f") / static_cast<double>(rectangle.size()), -7.395, 2e-3);
  expect_read_back(rectangle, AtomStyle::molecular);

  // The cell of two atoms three times each way, turned in space and shifted, its second vector tilted by two
  // lattice vectors more.
  const double a = 1.4204 * std::sqrt(3.0);
  Molecule oblique;
  const Vec3 a1(a, 0, 0), a2(0.5 * a, std::sqrt(0.75) * a, 0);
  Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, -3).normalized()).toRotationMatrix();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (const double s : {0.0, 1.0 / 3.0})
        oblique.positions.push_back(turn * ((i + s - 1.0) * a1 + (j + s - 1.0) * a2 + Vec3(0.3, 9.0, -2.0)));
  oblique.elements.assign(oblique.positions.size(), Element::carbon);
  oblique.cell = Cell{};
  oblique.cell->vectors << 4.0 * a1, 4.0 * a2 + 8.0 * a1, Vec3(0, 0, 1);
  oblique.cell->vectors = turn * oblique.cell->vectors;
  oblique.cell->periodic = {true, true, false};
  oblique.bonds = topology::bonds_within(oblique.positions, oblique.elements, &*oblique.cell);
  EXPECT_EQ(oblique.bonds.size(), 48u);
  write(oblique, AtomStyle::full);
  EXPECT_NEAR(energy(AtomStyle::full, "p p f") / 32.0, -7.395, 2e-3);
  expect_read_back(oblique, AtomStyle::full);
}

TEST_F(LammpsReads, ATubeThatIsPeriodicAlongItsAxis) {
  const Molecule tube = structures::periodic_tube(6, 3, 1);
  write(tube, AtomStyle::atomic);
  energy(AtomStyle::atomic, "f f p");
  expect_read_back(tube, AtomStyle::atomic);
}

TEST_F(LammpsReads, Hydrogen) {
  Molecule methane;
  methane.positions = {Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)};
  for (Vec3& p : methane.positions) p *= 1.089 / std::sqrt(3.0);
  methane.elements.assign(5, Element::hydrogen);
  methane.elements[0] = Element::carbon;
  methane.bonds = {{0, 1, {0, 0, 0}}, {0, 2, {0, 0, 0}}, {0, 3, {0, 0, 0}}, {0, 4, {0, 0, 0}}};
  write(methane, AtomStyle::full);
  // Atomisation energy of methane in REBO2: 18.185 eV (Brenner et al., Table 13).
  EXPECT_NEAR(energy(AtomStyle::full, "f f f"), -18.185, 0.02);
  expect_read_back(methane, AtomStyle::full);
}

// The same atoms, dumped in both ways as they move, from a tilted box.
TEST_F(LammpsReads, AndItsDumpsInYamlAreAsItsOthers) {
  Molecule sheet = structures::graphene(3, 2);
  sheet.cell->vectors.col(1) += 0.4 * sheet.cell->vectors.col(0);  // bonds do not matter here
  write(sheet, AtomStyle::atomic);
  std::ofstream(folder / "in.lammps") << "units metal\natom_style atomic\nboundary p p f\nread_data "
                                         "a.data\npair_style zero 3\npair_coeff * *\n"
                                         "velocity all create 3000 1\nfix 1 all nve\n"
                                         "dump 1 all custom 10 a.dump id type element x y z ix iy iz\n"
                                         "dump 2 all yaml 10 a.yaml id type element x y z ix iy "
                                         "iz\ndump_modify 2 units yes time yes thermo yes\n"
                                         "dump_modify 1 element C H format float %.15g\ndump_modify 2 "
                                         "element C H format float %.15g\nrun 20\n";
  const std::string command = fmt::format("cd \"{}\" && \"{}\" -in in.lammps -log log.lammps > screen 2>&1",
                                          folder.string(), NANOCARBON_LMP);
  const bool done = std::system(command.c_str()) == 0;
  std::ifstream file(folder / "screen");
  const std::string screen(std::istreambuf_iterator<char>(file), {});
  if (screen.find("Unrecognized dump style 'yaml'") != std::string::npos)
    GTEST_SKIP() << "this LAMMPS has no dump yaml (package EXTRA-DUMP)";
  ASSERT_TRUE(done) << screen;
  MoleculeFile custom(folder / "a.dump", {}), yaml(folder / "a.yaml", {});
  EXPECT_EQ(yaml.format(), MoleculeFormat::lammps_yaml);
  for (int k = 0; k < 3; ++k) {
    const auto a = custom.next(), b = yaml.next();
    ASSERT_TRUE(a && b) << k;
    EXPECT_EQ(b->step, 10 * k);
    EXPECT_EQ(a->step, b->step);
    EXPECT_EQ(a->ids, b->ids);
    EXPECT_EQ(a->molecule.elements, b->molecule.elements);
    EXPECT_EQ(a->molecule.positions, b->molecule.positions);
    EXPECT_EQ(a->molecule.cell->vectors, b->molecule.cell->vectors);
    EXPECT_EQ(b->molecule.cell->periodic, (std::array{true, true, false}));
    EXPECT_NE(b->molecule.cell->vectors(0, 1), 0.0);
  }
  EXPECT_FALSE(yaml.more());
  EXPECT_FALSE(yaml.next());
}

}  // namespace
}  // namespace nanocarbon::molecule
