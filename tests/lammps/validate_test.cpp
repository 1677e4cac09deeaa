// SPDX-License-Identifier: GPL-2.0-or-later
//! \file
//! \brief examples/validate.in as a user runs it, on data files of molecules and of periodic sheets.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "lammps/scripts.h"
#include "nanocarbon/molecule/formats/lammps_data.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"

namespace nanocarbon {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

// The data file that this project writes of a molecule; without its comments it is as other tools write it.
std::string data_file(const Molecule& molecule, bool comments) {
  std::stringstream lines;
  molecule::write_lammps_data(lines, molecule);
  std::string text;
  for (std::string line; std::getline(lines, line);)
    if (comments || !line.starts_with("#")) text += line + "\n";
  return comments ? text : "as other tools write it\n\n" + text;
}

test::ScriptResult validate(const Molecule& molecule, bool comments, const std::string& more = "") {
  const std::string write_data =
      "cat > molecule.data <<'end of data'\n" + data_file(molecule, comments) + "end of data\n";
  return test::run_script(
      NANOCARBON_HOST_PROGRAM, "include " NANOCARBON_EXAMPLES "/validate.in\n", write_data,
      "-var data molecule.data -var steps 20 -var pixels 0 -var plugin " NANOCARBON_PLUGIN_FILE " " + more);
}

TEST(Validate, AMoleculeIsInFreeSpace) {
  for (const bool comments : {true, false}) {
    const test::ScriptResult result = validate(structures::fullerene(1, 1), comments);
    EXPECT_EQ(result.exit_code, 0) << result.output;
    EXPECT_THAT(result.output, HasSubstr("orientable, genus 0, 0 boundary loops"));
    EXPECT_THAT(result.output, HasSubstr("verdict: intact, 0 atoms repelled"));
    const std::string notice = "molecule.data does not say which directions are periodic";
    EXPECT_THAT(result.output, comments ? testing::Matcher<std::string>(Not(HasSubstr(notice)))
                                        : testing::Matcher<std::string>(HasSubstr(notice)));
  }
}

TEST(Validate, ASheetIsPeriodicWhereItsFileSaysSo) {
  const test::ScriptResult result = validate(structures::graphene(4, 3), true);
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("orientable, genus 1, 0 boundary loops"));
  EXPECT_THAT(result.output, HasSubstr("verdict: intact, 0 atoms repelled"));
}

TEST(Validate, ASheetIsPeriodicWhereTheCommandLineSaysSo) {
  const test::ScriptResult result = validate(structures::graphene(4, 3), false, "-var boundary 'p p f'");
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("orientable, genus 1, 0 boundary loops"));
}

TEST(Validate, TakesEveryPairStyleAndFindsItsFile) {
  for (const auto& [pair, file] : {std::pair("rebo", "CH.rebo"),
                                   {"rebo/opt", "CH.rebo"},
                                   {"airebo", "CH.airebo"},
                                   {"airebo/opt", "CH.airebo"},
                                   {"airebo/morse", "CH.airebo-m"},
                                   {"airebo/morse/opt", "CH.airebo-m"}}) {
    SCOPED_TRACE(pair);
    const test::ScriptResult result =
        validate(structures::fullerene(1, 1), true, std::string("-var pair ") + pair + " -echo screen");
    EXPECT_EQ(result.exit_code, 0) << result.output;
    EXPECT_THAT(result.output, ContainsRegex(std::string("pair_coeff .*/") + file + " C"));
    EXPECT_THAT(result.output, HasSubstr("verdict: intact, 0 atoms repelled"));
  }
}

TEST(Validate, TakesAParameterFile) {
  const std::string copy = "-var potential copy-of.CH.rebo ";
  EXPECT_THAT(validate(structures::fullerene(1, 1), true, copy).output, HasSubstr("cannot open"));
  const test::ScriptResult result =
      validate(structures::fullerene(1, 1), true, "-var pair rebo -var potential " NANOCARBON_CH_REBO);
  EXPECT_EQ(result.exit_code, 0) << result.output;
}

TEST(Validate, SaysWhichPairStylesThereAre) {
  const test::ScriptResult result = validate(structures::fullerene(1, 1), true, "-var pair tersoff");
  EXPECT_NE(result.exit_code, 0);
  EXPECT_THAT(result.output, HasSubstr("pair is tersoff, but must be rebo, airebo"));
}

}  // namespace
}  // namespace nanocarbon
