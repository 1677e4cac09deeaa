// SPDX-License-Identifier: GPL-2.0-or-later
//! \file
//! \brief lmp-nanocarbon as a user runs it: the plugin command, and what fix bond/topology refuses.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "lammps/scripts.h"
#include "lammps_version.h"

namespace nanocarbon {
namespace {

using test::run_script;
using test::ScriptResult;
using testing::HasSubstr;
using testing::Not;

const std::string program = NANOCARBON_HOST_PROGRAM;
const std::string object = NANOCARBON_PLUGIN_FILE;
const std::string load = "plugin load " + object + "\n";

// A square of four carbon atoms is all that these scripts need.
std::string square(const std::string& before = "") {
  return "units metal\nboundary f f f\natom_modify map yes\n" + before +
         "region box block 0 20 0 20 0 20\ncreate_box 1 box\n"
         "create_atoms 1 single 10 10 10\ncreate_atoms 1 single 11.4 10 10\n"
         "create_atoms 1 single 11.4 11.4 10\ncreate_atoms 1 single 10 11.4 10\n"
         "mass 1 12.011\npair_style zero 6.0\npair_coeff * *\n";
}

std::string with_fix(const std::string& arguments) {
  return load + square() + "fix watch all bond/topology " + arguments + "\nrun 0\n";
}

void expect_error(const ScriptResult& result, const std::string& message) {
  EXPECT_NE(result.exit_code, 0);
  EXPECT_THAT(result.output, HasSubstr("ERROR"));
  EXPECT_THAT(result.output, HasSubstr(message));
}

TEST(PluginCommand, LoadsAndListsStyles) {
  const ScriptResult result = run_script(program, load + "plugin list\n");
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("Loading plugin: fix bond/topology"));
  EXPECT_THAT(result.output, HasSubstr("1: fix style plugin bond/topology"));
}

TEST(PluginCommand, FindsTheObjectBesideTheProgramAndInThePluginPath) {
  EXPECT_THAT(run_script(program, "plugin load nanocarbonplugin.so\n").output, HasSubstr("Loading plugin"));
  const std::string folder = std::filesystem::path(object).parent_path();
  const ScriptResult result =
      run_script(program, "plugin load nanocarbonplugin.so\n", "LAMMPS_PLUGIN_PATH=/nowhere:" + folder);
  EXPECT_THAT(result.output, HasSubstr("Loading plugin"));
}

TEST(PluginCommand, SaysWhereItLookedForAMissingObject) {
  const ScriptResult result =
      run_script(program, "plugin load absent.so\n", "LAMMPS_PLUGIN_PATH=/some/folder");
  expect_error(result, "plugin load: no file absent.so");
  EXPECT_THAT(result.output, HasSubstr("/some/folder/absent.so"));
}

TEST(PluginCommand, RefusesAFileThatIsNoPlugin) {
  expect_error(run_script(program, "plugin load " + program + "\n"), "plugin load: cannot open");
}

TEST(PluginCommand, RefusesAnObjectForAnotherLammpsAndNamesBothVersions) {
  const ScriptResult result = run_script(program, "plugin load " NANOCARBON_OTHER_PLUGIN_FILE "\n");
  expect_error(result, "was built for LAMMPS 1 Jan 2030, but this is LAMMPS " NANOCARBON_LAMMPS_DATE);
}

TEST(PluginCommand, LoadsAgainAfterClear) {
  const std::string use = square() + "fix watch all bond/topology 1\nrun 0\n";
  const ScriptResult result = run_script(program, load + use + "clear\nplugin list\n" + load + use);
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("Currently loaded plugins\nLoading plugin"));
}

TEST(PluginCommand, UnloadDeletesTheFixesOfTheStyle) {
  const ScriptResult result =
      run_script(program, load + square() +
                              "fix watch all bond/topology 1\nrun 0\nplugin unload fix bond/topology\nrun 0\n"
                              "plugin list\nfix watch all bond/topology 1\n");
  EXPECT_THAT(result.output, HasSubstr("Unloading fix style bond/topology"));
  expect_error(result, "fix style 'bond/topology'");
}

TEST(PluginCommand, ALoadedStyleIsNotLoadedTwice) {
  EXPECT_THAT(run_script(program, load + load).output, HasSubstr("Ignoring load of fix style bond/topology"));
}

TEST(PluginCommand, TakesWhatLmpTakes) {
  const ScriptResult result =
      run_script(program, load + "print \"${word}\"\n", "", "-var word seen -echo screen");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, HasSubstr("\nseen\n"));
}

TEST(PluginCommand, WorksInPartitions) {
  const ScriptResult result =
      run_script("mpirun --allow-run-as-root --oversubscribe -n 2 " + program,
                 load + square() + "fix watch all bond/topology 1\nrun 0\n", "", "-partition 1 1");
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("Running on 2 partitions"));
}

TEST(FixBondTopologyErrors, IllegalArgumentsAreNamed) {
  expect_error(run_script(program, with_fix("")), "Illegal fix bond/topology command: the number of steps");
  expect_error(run_script(program, with_fix("0")), "must be above 0");
  expect_error(run_script(program, with_fix("1 colour red")), "unknown keyword colour");
  expect_error(run_script(program, with_fix("1 form")), "the value of form is missing");
  expect_error(run_script(program, with_fix("1 form 2.1")), "break must not be below form");
  expect_error(run_script(program, with_fix("1 maxring 2")), "maxring must be from 3 to 255");
  expect_error(run_script(program, with_fix("1 halt perhaps")), "halt must be yes or no, not perhaps");
  expect_error(run_script(program, with_fix("1 file /nowhere/changes")), "cannot open file /nowhere/changes");
}

TEST(FixBondTopologyErrors, UnitsOtherThanAngstromAreAnError) {
  const auto in_units = [](const std::string& units) {
    std::string script = load + square() + "fix watch all bond/topology 1\nrun 0\n";
    return run_script(program, script.replace(script.find("metal"), 5, units));
  };
  const ScriptResult real = in_units("real");
  EXPECT_EQ(real.exit_code, 0) << real.output;
  expect_error(in_units("lj"),
               "Fix bond/topology needs units metal or real, whose lengths are in Angstrom, not lj");
  expect_error(in_units("nano"), "not nano");
}

TEST(FixBondTopologyOutput, AnEmptyGroupIsWarnedOf) {
  const ScriptResult result =
      run_script(program, load + square() +
                              "group none type 1\ngroup none clear\nfix watch none bond/topology 1\nrun 0\n");
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("WARNING: Fix bond/topology watch has no atoms to watch"));
}

// Two atoms of the first type, one of the second, with these masses.
std::string two_types(const std::string& masses, const std::string& fix, const std::string& pair = "zero 6.0",
                      const std::string& coefficients = "* *") {
  return load + "units metal\nboundary f f f\nregion box block 0 20 0 20 0 20\ncreate_box 2 box\n" +
         "create_atoms 1 single 10 10 10\ncreate_atoms 1 single 11.4 10 10\ncreate_atoms 2 single 14 10 "
         "10\n" +
         masses + "\ngroup first type 1\npair_style " + pair + "\npair_coeff " + coefficients +
         "\nfix watch " + fix + "\nrun 0\n";
}

TEST(FixBondTopologyTypes, AreSaidInTheLog) {
  const auto output = [](const std::string& script) { return run_script(program, script).output; };
  EXPECT_THAT(
      output(two_types("mass 1 12.0107\nmass 2 1.00794", "all bond/topology 1")),
      HasSubstr(
          "fix bond/topology watch: type 1 (mass 12.0107) is carbon, type 2 (mass 1.00794) is hydrogen\n"));
  EXPECT_THAT(output(two_types("mass * 12.011", "all bond/topology 1")),
              HasSubstr("type 2 (mass 12.011) is carbon\n"));
  EXPECT_THAT(output(two_types("mass * 1.0", "all bond/topology 1 element C H")),
              HasSubstr("type 1 (mass 1) is carbon by element, type 2 (mass 1) is hydrogen by element\n"));
  EXPECT_THAT(
      output(two_types("mass * 1.0", "all bond/topology 1", "rebo/opt", "* * " NANOCARBON_CH_REBO " C H")),
      HasSubstr("type 1 (mass 1) is carbon by pair_coeff, type 2 (mass 1) is hydrogen by pair_coeff\n"));
  // Types that no watched atom is of may be anything.
  EXPECT_THAT(output(two_types("mass 1 12.011\nmass 2 196.97", "first bond/topology 1")),
              HasSubstr("fix bond/topology watch: type 1 (mass 12.011) is carbon\n"));
}

TEST(FixBondTopologyTypes, OthersThanCarbonAndHydrogenAreRefusedByName) {
  const auto refuses = [](const std::string& masses, const std::string& arguments,
                          const std::string& message) {
    expect_error(run_script(program, two_types(masses, "all bond/topology 1" + arguments)), message);
  };
  refuses("mass 1 12.011\nmass 2 196.97", "",
          "atom type 2 (mass 196.97) is gold: leave its atoms out of the group");
  refuses("mass 1 12.011\nmass 2 28.0855", " element C NULL", "is silicon");
  refuses("mass 1 12.011\nmass 2 13.019", "", "is no element by its mass");
  refuses("mass * 12.011", " element C", "element needs C, H or NULL for each of the 2 atom types");
  refuses("mass * 12.011", " element C Au", "element must be C, H or NULL, not Au");
}

TEST(FixBondTopologyErrors, AtomsWithoutIdsAreAnError) {
  expect_error(run_script(program, load + "units metal\natom_modify id no\nregion box block 0 20 0 20 0 20\n"
                                          "create_box 1 box\ncreate_atoms 1 single 10 10 10\nmass 1 12.011\n"
                                          "fix watch all bond/topology 1\n"),
               "needs atom IDs");
}

TEST(FixBondTopologyErrors, GhostsThatDoNotReachAreAnErrorThatSaysWhatToDo) {
  const std::string script = load + square() + "pair_style zero 1.0\npair_coeff * *\nneighbor 0.1 bin\n";
  expect_error(run_script(program, script + "fix watch all bond/topology 1\nrun 0\n"),
               "use comm_modify cutoff");
  const ScriptResult mended =
      run_script(program, script + "comm_modify cutoff 3.0\nfix watch all bond/topology 1\nrun 0\n");
  EXPECT_EQ(mended.exit_code, 0) << mended.output;
}

TEST(FixBondTopologyErrors, DynamicGroupsAreRefused) {
  const ScriptResult result = run_script(
      program, load + square() + "group some dynamic all every 1\nfix watch some bond/topology 1\nrun 0\n");
  EXPECT_NE(result.exit_code, 0);
  EXPECT_THAT(result.output, HasSubstr("dynamic group"));
}

// Two bonded carbon atoms, of the given types, as a data file with bonds makes them.
std::string bonded_pair(const std::string& special_bonds, const std::string& elements) {
  return load + "units metal\natom_style bond\nboundary f f f\n" + special_bonds +
         "region box block 0 20 0 20 0 20\ncreate_box 2 box bond/types 1 extra/bond/per/atom 2 "
         "extra/special/per/atom 4\n"
         "create_atoms 1 single 10 10 10\ncreate_atoms 2 single 11.4 10 10\nmass * 12.011\n"
         "bond_style zero\nbond_coeff 1\ncreate_bonds single/bond 1 1 2\n"
         "pair_style hybrid/overlay rebo/opt zero 4.0\npair_coeff * * zero\npair_coeff * * "
         "rebo/opt " NANOCARBON_CH_REBO " " +
         elements + "\nrun 0\n";
}

TEST(ReboOptErrors, BondsThatSpecialBondsTakesOutAreAnError) {
  expect_error(
      run_script(program, bonded_pair("", "C C")),
      "rebo/opt needs the neighbors that special_bonds takes out, such as atoms 1 and 2: use special_bonds "
      "lj/coul 1 1 1");
  for (const std::string& fine :
       {bonded_pair("special_bonds lj/coul 1 1 1\n", "C C"),
        bonded_pair("special_bonds lj/coul 1e-50 1 1\n", "C C"), bonded_pair("", "C NULL")}) {
    const ScriptResult result = run_script(program, fine);
    EXPECT_EQ(result.exit_code, 0) << result.output;
  }
}

TEST(FixBondTopologyOutput, SummaryInTheLogAndPicturesWithBonds) {
  const ScriptResult result =
      run_script(program, load + square() +
                              "fix watch all bond/topology 1\nrun 0\n"
                              "write_dump all image square.ppm f_watch[1] type fix watch type 0.2 0\n"
                              "shell ls square.ppm\nthermo_style custom step f_watch f_watch[*]\nrun 0\n");
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("fix bond/topology watch: intact at step 0\n"));
  EXPECT_THAT(result.output, HasSubstr("now: 4 bonds, 1 piece, Euler characteristic 1"));
  EXPECT_THAT(result.output, HasSubstr("square.ppm\n"));
}

}  // namespace
}  // namespace nanocarbon
