// SPDX-License-Identifier: GPL-2.0-or-later
// `nanocarbon energy` on files from elsewhere: written by ASE and LAMMPS, and as OVITO, VMD, msi2lmp, Moltemplate and
// GPUMD write them. Each gives LAMMPS's energy, or a refusal that says what is missing.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "support/run_program.h"
#include "support/temporary_folder.h"

namespace nanocarbon::cli {
namespace {

using nlohmann::json;
using test::ProgramOutcome;
using testing::AllOf;
using testing::HasSubstr;

const std::string files = NANOCARBON_FILES "/";

ProgramOutcome energy(const std::string& arguments) {
  return test::run_command(NANOCARBON_PROGRAM " energy " + arguments);
}
// The JSON that follows what warnings there are.
double energy_of(const std::string& arguments) {
  const ProgramOutcome outcome = energy(arguments + " --json");
  EXPECT_EQ(outcome.exit_code, 0) << arguments << ": " << outcome.output;
  const std::size_t begin = outcome.output.find('{');
  if (outcome.exit_code != 0 || begin == std::string::npos) return 0.0;
  return json::parse(outcome.output.substr(begin))["energy"];
}

// Of pair_style rebo (LAMMPS 29 Sep 2021), eV.
constexpr double c60 = -408.833, benzene = -59.2791563100061, bilayer = -59.1599381958031,
                 graphene = -354.960;

TEST(EnergyOfFiles, FromOtherProgramsIsThatOfLammps) {
  for (const std::string name :
       {"c60-labels.xyz", "c60-lower-case.xyz", "c60-fortran.xyz", "c60-aromatic.xyz --types CA=C"})
    EXPECT_NEAR(energy_of(files + name), c60, 1e-3) << name;
  for (const std::string name :
       {"benzene-topotools.data", "benzene-msi2lmp.lmp", "system-moltemplate.data",
        "data.benzene-type-labels", "benzene-charge.lmpdat", "benzene-ovito.dump", "benzene-ovito.xyz",
        "model.xyz", "benzene-dump-types.xyz --types C H", "benzene-dump-types.xyz --types 1=C,2=H"})
    EXPECT_NEAR(energy_of(files + name), benzene, 2e-4) << name;
  EXPECT_NEAR(energy_of(files + "bilayer.data2 --types C C"), bilayer, 1e-6);
  EXPECT_NEAR(energy_of("--types C C " + files + "bilayer.data2"), bilayer, 1e-6);
  EXPECT_NEAR(energy_of(files + "graphene-unnamed-types.xyz --types C"), graphene, 1e-3);
}

TEST(EnergyOfFiles, ThatDoNotSayWhatTheirAtomsAreIsRefused) {
  for (const auto& [name, message] : std::vector<std::pair<std::string, std::string>>{
           {"bilayer.data2", "--types C C"},
           {"gold.data", "gold (Au)"},
           {"graphene-unnamed-types.xyz", "--types 1=C"},
           {"c60-aromatic.xyz", "could be calcium"},
           {"benzene-dump-types.xyz", "is a number"},
           {"graphene-no-lattice.extxyz", "there is no Lattice"}}) {
    const ProgramOutcome outcome = energy(files + name);
    EXPECT_EQ(outcome.exit_code, 5) << name;
    EXPECT_THAT(outcome.output, AllOf(HasSubstr(name + ":"), HasSubstr(message))) << name;
  }
}

TEST(EnergyOfFiles, ComesFromStandardInputAndPackedFiles) {
  const test::TemporaryFolder folder;
  const std::string packed = (folder / "c60.xyz.gz").string(),
                    program = NANOCARBON_PROGRAM " energy - --json";
  ASSERT_EQ(test::run_command("gzip -c " + files + "c60-labels.xyz > " + packed).exit_code, 0);
  EXPECT_NEAR(energy_of(packed), c60, 1e-3);
  for (const std::string& input : {packed, files + "c60-labels.xyz"})
    for (const std::string& command :
         {"(cat " + input + " | " + program + ")", "(" + program + " < " + input + ")"})
      EXPECT_NEAR(json::parse(test::run_command(command).output)["energy"], c60, 1e-3) << command;
}

TEST(EnergyOfFiles, WrittenByAseIsTheSame) {
  if (std::string(NANOCARBON_ASE_PYTHON).empty())
    GTEST_SKIP() << "no Python with ASE was found (python3-ase)";
  const test::TemporaryFolder folder;
  const std::string to = (folder / "").string();
  const ProgramOutcome written =
      test::run_command(std::string(NANOCARBON_ASE_PYTHON) + " " NANOCARBON_WRITE_WITH_ASE " " + files +
                        "c60-labels.xyz " + to);
  ASSERT_EQ(written.exit_code, 0) << written.output;
  for (const std::string name : {"plain.xyz", "extended.xyz", "atomic.data --types C",
                                 "charge.data --types C", "full.data --types C", "POSCAR", "direct.vasp"})
    EXPECT_NEAR(energy_of(to + name), c60, 1e-3) << name;
  EXPECT_NEAR(energy_of(to + "movie.xyz --frame -1"), c60, 1e-3);
  EXPECT_NEAR(energy_of(to + "c60.cif"), c60, 0.02);  // five digits of fractions of 25 Angstrom
}

TEST(EnergyOfFiles, WrittenByLammpsIsTheSame) {
  if (std::string(NANOCARBON_LMP).empty()) GTEST_SKIP() << "no LAMMPS program lmp was found";
  const test::TemporaryFolder folder;
  const std::string at = (folder / "").string();
  ASSERT_EQ(test::run_command("cp " + files + "benzene-msi2lmp.lmp " + at + "a.data").exit_code, 0);
  std::ofstream(folder / "in")
      << "units metal\natom_style full\npair_style zero 6.0 nocoeff\nbond_style zero nocoeff\n"
         "read_data a.data\nspecial_bonds lj/coul 1 1 1\npair_coeff * *\nbond_coeff *\n"
         "write_dump all xyz named.xyz modify element C H\nwrite_dump all xyz types.xyz\n"
         "displace_atoms all move 9 0 9\n"  // across the boundary
         "dump 1 all custom 1 named.dump id type element x y z\ndump_modify 1 element C H format float %.9g\n"
         "dump 2 all custom 1 scaled.dump.gz id element xs ys zs ix iy iz\n"
         "dump_modify 2 element C H format float %.9g sort id\n"
         "dump 3 all custom 1 masses.dump id mass xu yu zu\ndump_modify 3 format float %.9g\n"
         "dump 4 all atom 1 atoms.dump\n"
         "run 0\nwrite_data full.data nocoeff\n"
         "undump 1\nundump 2\nundump 3\nundump 4\nchange_box all triclinic\nchange_box all xy final 4.0\n"
         "write_data tilted.data\nwrite_dump all custom tilted.dump id element x y z modify element C H "
         "format float %.9g\n";
  const ProgramOutcome ran = test::run_command("cd " + at + " && " NANOCARBON_LMP " -in in -log none");
  ASSERT_EQ(ran.exit_code, 0) << ran.output;
  for (const std::string name :
       {"named.dump", "scaled.dump.gz", "masses.dump", "atoms.dump --types C H", "named.xyz",
        "types.xyz --types C H", "full.data", "tilted.data", "tilted.dump"})
    EXPECT_NEAR(energy_of(at + name), benzene, 2e-4) << name;
  EXPECT_THAT(energy(at + "atoms.dump").output, HasSubstr("--types C H"));
}

}  // namespace
}  // namespace nanocarbon::cli
