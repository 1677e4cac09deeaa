// SPDX-License-Identifier: GPL-2.0-or-later
//! \file
//! \brief pair_style rebo/opt as input scripts use it, on one and several ranks.

#include <gmock/gmock.h>

#include <cmath>

#include "compute.h"
#include "force.h"
#include "lammps/lammps_run.h"
#include "lammps/test_molecules.h"
#include "modify.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "pair.h"
#include "potential/rebo2/comparison_structures.h"

namespace nanocarbon::test {
namespace {

//! A periodic sheet with holes, hydrogens on it and stretched bonds: fast, general and mixed bonds on every
//! rank.
Molecule mixed_sheet() {
  Molecule m = structures::graphene(14, 8);
  for (const std::size_t i : {400u, 223u, 222u, 57u}) {
    m.positions.erase(m.positions.begin() + static_cast<std::ptrdiff_t>(i));
    m.elements.erase(m.elements.begin() + static_cast<std::ptrdiff_t>(i));
  }
  for (std::size_t i = 5, carbons = m.size(); i < carbons; i += 23) {
    m.positions.push_back(m.positions[i] + Vec3(0.0, 0.0, 1.1));
    m.elements.push_back(Element::hydrogen);
  }
  m.bonds.clear();
  m.rings = {};
  rattle(m, 0.08, 4);
  return m;
}

double energy(LammpsRun& run) {
  auto* pe = run.lammps().modify->compute[run.lammps().modify->find_compute("thermo_pe")];
  return pe->scalar;
}

std::vector<Vec3> trajectory_end(const Molecule& molecule, const std::string& style,
                                 const std::vector<std::string>& lines) {
  LammpsRun run;
  run.read(molecule, style);
  run.commands(lines);
  return run.positions();
}

double largest_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

const std::vector<std::string> dynamics = {"velocity all create 600 81 loop geom", "fix 1 all nve",
                                           "run 100"};

TEST(ReboOpt, TrajectoriesStartOutAsThoseOfRebo) {
  for (const Molecule& m : {mixed_sheet(), structures::fullerene(3, 2)}) {
    const auto rebo = trajectory_end(m, "rebo", dynamics);
    const auto ours = trajectory_end(m, "rebo/opt", dynamics);
    ASSERT_EQ(ours.size(), m.size());
    EXPECT_LT(largest_distance(rebo, ours), 1e-8);
  }
}

TEST(ReboOpt, TrajectoriesAgreeWithFrequentReneighbouringSortingAndMigration) {
  std::vector<std::string> lines = {"neighbor 0.4 bin",
                                    "neigh_modify every 1 delay 0 check yes",
                                    "atom_modify sort 7 3.0",
                                    "velocity all create 3000 81 loop geom",
                                    "velocity all ramp vx 0 20 y 0 40 sum yes",
                                    "fix 1 all nve",
                                    "run 100"};
  const Molecule m = mixed_sheet();
  const auto rebo = trajectory_end(m, "rebo", lines);
  EXPECT_LT(largest_distance(rebo, trajectory_end(m, "rebo/opt", lines)), 1e-7);
  lines[0] = "neighbor 0.4 nsq";
  EXPECT_LT(largest_distance(rebo, trajectory_end(m, "rebo/opt", lines)), 1e-7);
}

TEST(ReboOpt, SuffixOptTurnsReboIntoIt) {
  LammpsRun run;
  run.command("suffix opt");
  run.read(structures::fullerene(1, 1), "rebo");
  EXPECT_NE(run.lammps().force->pair_match("rebo/opt", 1), nullptr);
  run.command("run 0");
  // C60 of springs, not relaxed; at most an eV an atom above REBO's minimum of -410.5 eV, and never below.
  EXPECT_GT(energy(run), -410.6);
  EXPECT_LT(energy(run), -350.0);
}

TEST(ReboOpt, MinimisesToTheKnownEnergyOfC60) {
  LammpsRun run;
  run.read(structures::fullerene(1, 1), "rebo/opt");
  run.command("minimize 0 1e-9 1000 10000");
  EXPECT_NEAR(energy(run) / 60.0, -6.8420645371, 1e-9);
}

TEST(ReboOpt, RelaxesTheBoxOfGraphene) {
  LammpsRun run;
  Molecule m = structures::graphene(6, 4);
  const Mat3 strain = Vec3(1.01, 0.985, 1.0).asDiagonal();
  m.cell->vectors = strain * m.cell->vectors;
  for (Vec3& p : m.positions) p = strain * p;
  run.read(m, "rebo/opt");
  run.commands({"min_style cg", "fix 1 all box/relax x 0.0 y 0.0 couple none vmax 0.001",
                "minimize 0 1e-8 1000 10000"});
  EXPECT_NEAR(energy(run) / static_cast<double>(m.size()), -7.3949972517, 1e-7);
}

TEST(ReboOpt, GoesOnFromARestartAsReboDoes) {
  const SharedFolder folder;
  const Molecule m = mixed_sheet();
  const std::vector<std::string> first = {"velocity all create 600 81 loop geom", "fix 1 all nve", "run 20",
                                          "write_restart " + folder / "r"};
  std::vector<std::vector<Vec3>> ends;
  for (const std::string style : {"rebo", "rebo/opt"}) {
    LammpsRun run;
    run.read(m, style);
    run.commands(first);
    run.commands({"clear", "plugin load " NANOCARBON_PLUGIN_FILE, "read_restart " + folder / "r",
                  "pair_style " + style, "pair_coeff * * " NANOCARBON_CH_REBO " C H", "fix 1 all nve",
                  "run 20"});
    ends.push_back(run.positions());
  }
  EXPECT_LT(largest_distance(ends[0], ends[1]), 1e-9);
}

TEST(ReboOpt, SharesASystemWithAnotherStyleUnderHybrid) {
  Molecule m = mixed_sheet();
  std::vector<std::vector<Vec3>> ends;
  std::vector<double> energies;
  for (const std::string style : {"rebo", "rebo/opt"}) {
    LammpsRun run;
    run.read(m, "zero 3.0");
    // Hydrogens see carbon by Lennard-Jones only.
    run.commands({"pair_style hybrid " + style + " lj/cut 6.0",
                  "pair_coeff * * " + style + " " NANOCARBON_CH_REBO " C NULL",
                  "pair_coeff 1 2 lj/cut 0.01 1.0", "pair_coeff 2 2 lj/cut 0.01 0.8",
                  "compute p all pressure NULL virial", "thermo_style custom step pe c_p[1] c_p[2] press"});
    run.commands(dynamics);
    ends.push_back(run.positions());
    energies.push_back(energy(run));
  }
  EXPECT_LT(largest_distance(ends[0], ends[1]), 1e-8);
  EXPECT_NEAR(energies[0], energies[1], 1e-7);
}

TEST(ReboOpt, GivesThePressureOfReboAlsoUnderHybrid) {
  for (const std::string before : {"", "hybrid "}) {
    std::vector<std::array<double, 6>> pressures;
    for (const std::string style : {"rebo", "rebo/opt"}) {
      LammpsRun run;
      run.read(mixed_sheet(), "zero 3.0");
      run.commands({"pair_style " + before + style,
                    "pair_coeff * * " + (before.empty() ? "" : style + " ") + NANOCARBON_CH_REBO " C H",
                    "thermo_style custom step pe pxx pyy pxy", "run 0"});
      auto* compute = run.lammps().modify->compute[run.lammps().modify->find_compute("thermo_press")];
      std::array<double, 6> pressure;
      std::copy_n(compute->vector, 6, pressure.begin());
      pressures.push_back(pressure);
    }
    // In bar, of pressures of 4e4 bar: the forces agree to more digits than this.
    for (int d = 0; d < 6; ++d) EXPECT_NEAR(pressures[0][d], pressures[1][d], 1e-5);
  }
}

TEST(ReboOpt, GivesComputePairTheEnergyOfRebo) {
  LammpsRun run;
  run.read(structures::fullerene(1, 1), "rebo/opt");
  run.commands({"compute parts all pair rebo/opt",
                "thermo_style custom step pe c_parts[1] c_parts[2] c_parts[3]", "run 0"});
  auto* parts = run.lammps().modify->compute[run.lammps().modify->find_compute("parts")];
  EXPECT_NEAR(parts->vector[0], energy(run), 1e-9);
  EXPECT_EQ(parts->vector[1], 0.0);
  EXPECT_EQ(parts->vector[2], 0.0);
}

}  // namespace
}  // namespace nanocarbon::test
