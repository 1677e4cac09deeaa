// SPDX-License-Identifier: GPL-2.0-or-later
//! \file
//! \brief The plugin in a LAMMPS that has the PLUGIN package, by its own `plugin load`. The variable
//! NANOCARBON_PLUGIN_LAMMPS names its lmp program; scripts/build-lammps-with-plugin.sh makes one.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "lammps/scripts.h"
#include "lammps_version.h"

namespace nanocarbon {
namespace {

using test::run_script;
using test::ScriptResult;
using testing::HasSubstr;

const std::string object = NANOCARBON_PLUGIN_FILE;

class PluginLoad : public testing::Test {
 protected:
  void SetUp() override {
    const char* const program = std::getenv("NANOCARBON_PLUGIN_LAMMPS");
    if (program == nullptr || *program == '\0')
      GTEST_SKIP() << "set NANOCARBON_PLUGIN_LAMMPS to what scripts/build-lammps-with-plugin.sh prints";
    lammps_ = program;
  }

  // C60 heated until its first bond breaks.
  ScriptResult run_example(const std::string& program) {
    const std::string folder = NANOCARBON_EXAMPLES "/topology";
    std::ifstream file(folder + "/c60.in");
    std::ostringstream script;
    script << file.rdbuf();
    return run_script(program, script.str(), "cp " + folder + "/c60.data . && ", "-var plugin " + object);
  }

  std::string lammps_;
};

TEST_F(PluginLoad, ThisLammpsHasThePackage) {
  EXPECT_THAT(run_script(lammps_, "info config\n").output, HasSubstr("PLUGIN"));
}

TEST_F(PluginLoad, ListsTheStyles) {
  const ScriptResult result = run_script(lammps_, "plugin load " + object + "\nplugin list\n");
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("fix style plugin bond/topology"));
}

TEST_F(PluginLoad, TheExampleRunsToItsFirstBrokenBond) {
  const ScriptResult result = run_example(lammps_);
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("the first bond is broken at step"));
  EXPECT_THAT(result.output, HasSubstr("since the start: 1 bond broken"));
}

TEST_F(PluginLoad, TheExampleRunsOnTwoRanks) {
  const ScriptResult result = run_example("mpirun --allow-run-as-root --oversubscribe -n 2 " + lammps_);
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("the first bond is broken at step"));
}

TEST_F(PluginLoad, WorksAgainAfterClear) {
  const std::string use = "plugin load " + object +
                          "\nunits metal\nboundary f f f\natom_modify map yes\nregion box block 0 9 0 9 0 9\n"
                          "create_box 1 box\ncreate_atoms 1 single 3 3 3\ncreate_atoms 1 single 4.4 3 3\n"
                          "mass 1 12.011\npair_style zero 4.0\npair_coeff * *\n"
                          "fix watch all bond/topology 1\nrun 0\n";
  const ScriptResult result = run_script(lammps_, use + "clear\n" + use);
  EXPECT_EQ(result.exit_code, 0) << result.output;
}

TEST_F(PluginLoad, AnObjectForAnotherLammpsIsRefusedAndBothVersionsNamed) {
  const ScriptResult result = run_script(lammps_, "plugin load " NANOCARBON_OTHER_PLUGIN_FILE "\n");
  EXPECT_NE(result.exit_code, 0);
  EXPECT_THAT(result.output,
              HasSubstr("was built for LAMMPS 1 Jan 2030, but this is LAMMPS " NANOCARBON_LAMMPS_DATE));
}

}  // namespace
}  // namespace nanocarbon
