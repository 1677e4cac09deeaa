// SPDX-License-Identifier: GPL-2.0-or-later
//! \file
//! \brief pair_style airebo/opt and airebo/morse/opt as input scripts use them, on one and several ranks.

#include <gmock/gmock.h>

#include <cmath>

#include "compute.h"
#include "force.h"
#include "lammps/lammps_run.h"
#include "lammps/test_molecules.h"
#include "modify.h"
#include "nanocarbon/core/space.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "pair.h"
#include "potential/airebo/reference.h"
#include "potential/rebo2/comparison_structures.h"

namespace nanocarbon::test {
namespace {

Molecule from_table(const std::string& name) {
  for (const AireboReferenceStructure& s : airebo_reference())
    if (s.name == name) return s.molecule;
  ADD_FAILURE() << "no " << name << " in the table";
  return {};
}

//! Two sheets with holes, hydrogens on them and stretched bonds, close enough for b* to matter.
Molecule two_sheets() {
  Molecule m = structures::graphene(9, 5);
  for (const std::size_t i : {123u, 122u, 57u}) {
    m.positions.erase(m.positions.begin() + static_cast<std::ptrdiff_t>(i));
    m.elements.erase(m.elements.begin() + static_cast<std::ptrdiff_t>(i));
  }
  const std::size_t sheet = m.size();
  for (std::size_t i = 0; i < sheet; ++i) {
    m.positions.push_back(m.positions[i] + Vec3(0.0, 1.42, 3.3));
    m.elements.push_back(Element::carbon);
  }
  for (std::size_t i = 5; i < sheet; i += 29) {
    m.positions.push_back(m.positions[i] - Vec3(0.0, 0.0, 1.1));
    m.elements.push_back(Element::hydrogen);
  }
  m.cell->vectors(2, 2) = 12.0;
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

//! Between nearest images: atoms are wrapped into the box whenever lists are made.
double largest_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b, const Space& space = {}) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, space.displacement(a[i], b[i]).norm());
  return largest;
}

//! The styles of LAMMPS and those of the plugin.
const std::vector<std::array<std::string, 2>> styles = {{"airebo 3.0", "airebo/opt 3.0"},
                                                        {"airebo/morse 3.0", "airebo/morse/opt 3.0"}};

TEST(AireboOpt, TrajectoriesStartOutAsThoseOfAirebo) {
  const std::vector<std::string> dynamics = {"velocity all create 600 81 loop geom", "fix 1 all nve",
                                             "run 60"};
  for (const auto& [airebo, opt] : styles)
    for (const Molecule& m : {two_sheets(), from_table("benzene_dimer"), from_table("c60_pair_9")}) {
      SCOPED_TRACE(opt);
      const auto theirs = trajectory_end(m, airebo, dynamics);
      const auto ours = trajectory_end(m, opt, dynamics);
      ASSERT_EQ(ours.size(), m.size());
      EXPECT_LT(largest_distance(theirs, ours), 1e-8);
    }
}

TEST(AireboOpt, TrajectoriesOfHotSoupAgreeWithFrequentReneighbouringSortingAndMigration) {
  std::vector<std::string> lines = {"neighbor 0.6 bin",
                                    "neigh_modify every 1 delay 0 check yes",
                                    "atom_modify sort 7 3.0",
                                    "velocity all create 2500 81 loop geom",
                                    "velocity all ramp vx 0 20 y 0 18 sum yes",
                                    "timestep 0.0002",
                                    "fix 1 all nve",
                                    "run 80"};
  const Molecule m = from_table("soup");
  const Space space(*m.cell);
  const auto theirs = trajectory_end(m, "airebo 3.0", lines);
  EXPECT_LT(largest_distance(theirs, trajectory_end(m, "airebo/opt 3.0", lines), space), 1e-7);
  lines[0] = "neighbor 0.6 nsq";
  EXPECT_LT(largest_distance(theirs, trajectory_end(m, "airebo/opt 3.0", lines), space), 1e-7);
  // Lists that are kept for long, so that bonds break and form in between.
  lines[0] = "neighbor 2.0 bin";
  EXPECT_LT(largest_distance(theirs, trajectory_end(m, "airebo/opt 3.0", lines), space), 1e-7);
}

TEST(AireboOpt, SuffixOptTurnsAireboIntoIt) {
  for (const auto& [airebo, opt] : styles) {
    LammpsRun run;
    run.command("suffix opt");
    run.read(structures::fullerene(1, 1), airebo);
    EXPECT_NE(run.lammps().force->pair_match(opt.substr(0, opt.find(' ')), 1), nullptr);
    run.command("run 0");
  }
}

TEST(AireboOpt, MinimisesToTheKnownEnergyOfC60) {
  for (const auto& [style, known] :
       {std::pair{"airebo/opt 3.0", -6.8080046046}, {"airebo/morse/opt 3.0", -6.8007720115}}) {
    LammpsRun run;
    run.read(structures::fullerene(1, 1), style);
    run.command("minimize 0 1e-9 1000 10000");
    EXPECT_NEAR(energy(run) / 60.0, known, 1e-9);
  }
}

TEST(AireboOpt, RelaxesTheBoxOfGraphite) {
  LammpsRun run;
  Molecule m = from_table("graphite");
  const Mat3 strain = Vec3(1.005, 0.99, 1.01).asDiagonal();
  m.cell->vectors = strain * m.cell->vectors;
  m.cell->origin = strain * m.cell->origin;
  for (Vec3& p : m.positions) p = strain * p;
  run.read(m, "airebo/opt 3.0");
  run.commands({"min_style cg", "fix 1 all box/relax aniso 0.0 vmax 0.001", "minimize 0 1e-7 2000 20000"});
  EXPECT_NEAR(energy(run) / static_cast<double>(m.size()), -7.4771092196, 1e-7);
}

TEST(AireboOpt, GoesOnFromARestartAsAireboDoes) {
  const SharedFolder folder;
  const Molecule m = two_sheets();
  std::vector<std::vector<Vec3>> ends;
  for (const std::string& style : styles[0]) {
    LammpsRun run;
    run.read(m, style);
    run.commands(
        {"velocity all create 600 81 loop geom", "fix 1 all nve", "run 10", "write_restart " + folder / "r"});
    run.commands({"clear", "plugin load " NANOCARBON_PLUGIN_FILE, "read_restart " + folder / "r",
                  "pair_style " + style, "pair_coeff * * " + potential_file(style) + " C H", "fix 1 all nve",
                  "run 10"});
    ends.push_back(run.positions());
  }
  EXPECT_LT(largest_distance(ends[0], ends[1]), 1e-9);
}

TEST(AireboOpt, SharesASystemWithAnotherStyleUnderHybrid) {
  const Molecule m = two_sheets();
  std::vector<std::vector<Vec3>> ends;
  std::vector<double> energies;
  for (const std::string style : {"airebo", "airebo/opt"}) {
    LammpsRun run;
    run.read(m, "zero 3.0");
    // Hydrogens see carbon by Lennard-Jones only.
    run.commands({"pair_style hybrid " + style + " 3.0 lj/cut 6.0",
                  "pair_coeff * * " + style + " " + potential_file(style) + " C NULL",
                  "pair_coeff 1 2 lj/cut 0.01 1.0", "pair_coeff 2 2 lj/cut 0.01 0.8",
                  "compute p all pressure NULL virial", "thermo_style custom step pe c_p[1] c_p[2] press",
                  "velocity all create 600 81 loop geom", "fix 1 all nve", "run 40"});
    ends.push_back(run.positions());
    energies.push_back(energy(run));
  }
  EXPECT_LT(largest_distance(ends[0], ends[1]), 1e-8);
  EXPECT_NEAR(energies[0], energies[1], 1e-7);
}

TEST(AireboOpt, GivesThePressureAndThePartsOfAirebo) {
  for (const auto& pair : styles)
    for (const std::string before : {"", "hybrid "}) {
      std::vector<std::array<double, 9>> results;
      for (const std::string& style : pair) {
        const std::string name = style.substr(0, style.find(' '));
        LammpsRun run;
        run.read(two_sheets(), "zero 3.0");
        run.commands({"pair_style " + before + style,
                      "pair_coeff * * " + (before.empty() ? "" : name + " ") + potential_file(style) + " C H",
                      "compute parts all pair " + name,
                      "thermo_style custom step pe pxx pyy pxy c_parts[1] c_parts[2] c_parts[3]", "run 0"});
        auto& modify = *run.lammps().modify;
        std::array<double, 9> result;
        std::copy_n(modify.compute[modify.find_compute("thermo_press")]->vector, 6, result.begin());
        std::copy_n(modify.compute[modify.find_compute("parts")]->vector, 3, result.begin() + 6);
        results.push_back(result);
      }
      for (int d = 0; d < 6; ++d) EXPECT_NEAR(results[0][d], results[1][d], 1e-5) << d;  // bar
      for (int d = 6; d < 9; ++d) EXPECT_NEAR(results[0][d], results[1][d], 1e-8) << d;  // eV
    }
}

}  // namespace
}  // namespace nanocarbon::test
