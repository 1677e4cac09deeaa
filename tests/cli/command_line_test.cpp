// SPDX-License-Identifier: GPL-2.0-or-later
// What the program makes of its arguments: help, options that are refused, exit codes, messages.
#include <gmock/gmock.h>

#include <string>

#include "support/program_test.h"

namespace nanocarbon::cli {
namespace {

using testing::HasSubstr;

using CommandLine = test::ProgramTest;

TEST_F(CommandLine, HelpAndVersionSucceed) {
  EXPECT_EQ(run("--help").exit_code, 0);
  EXPECT_EQ(run("--version").exit_code, 0);
  for (const std::string subcommand : {"inspect", "build"}) {
    const Outcome help = run(subcommand + " --help");
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_THAT(help.out, HasSubstr("Examples:"));
  }
}

TEST_F(CommandLine, PrintsItsHelpWhenNothingIsAskedOfIt) {
  const Outcome outcome = run("");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, run("--help").out);
  for (const char* subcommand : {"inspect", "build", "make", "energy", "analyse"})
    EXPECT_THAT(outcome.out, HasSubstr(subcommand));
}

TEST_F(CommandLine, EachKindOfFailureHasItsExitCodeAndLeavesNoFile) {
  const std::string sound = octahedron();
  const std::string truncated = file("truncated.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n");
  const std::string moebius_edge =
      file("three.off", "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n3 0 1 2\n3 1 0 3\n3 0 1 4\n");
  const auto build = [&](const std::string& rest) {
    return run("build " + rest + " -o " + path("out.data"));
  };
  EXPECT_EQ(run("--nonsense").exit_code, 2);
  EXPECT_EQ(run("frobnicate").exit_code, 2);
  EXPECT_EQ(build(sound + " --atoms 100 --length 20").exit_code, 2);
  EXPECT_EQ(build(sound + " --atoms none").exit_code, 2);
  EXPECT_EQ(build(sound + " --atoms 100 --min-bond 2 --max-bond 1").exit_code, 2);
  EXPECT_EQ(build(path("missing.off")).exit_code, 3);
  EXPECT_EQ(build(folder.path().string()).exit_code, 3);
  EXPECT_EQ(build(truncated).exit_code, 4);
  EXPECT_EQ(build(moebius_edge).exit_code, 5);
  EXPECT_EQ(build(sound).exit_code, 6);
  EXPECT_EQ(build(sound + " --atoms 1000000000000000").exit_code, 6);
  EXPECT_EQ(build(sound + " --atoms 3900000000").exit_code, 6);  // more than a terabyte
  EXPECT_EQ(run("build " + sound + " --atoms 100 -o " + path("none/out.data")).exit_code, 7);
  EXPECT_FALSE(exists("out.data"));
}

TEST_F(CommandLine, MessagesNameTheFileAndThePlace) {
  const std::string bad = file("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n");
  const Outcome outcome = run("build " + bad + " -o " + path("out.data"));
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("bad.off:5"));
}

TEST_F(CommandLine, OptionsThatMakeNoSenseAreRefusedBeforeAnyWork) {
  const std::string build = "build " + octahedron() + " -o " + path("out.data");
  for (const std::string options :
       {" --atoms 0", " --atoms -5", " --length nan", " --scale 0", " --margin nan", " --margin 1e300",
        " --threads 0", " --threads 1.5", " --seed -1", " --recipe thesis --local-threshold nan",
        // Of another recipe than the one asked for.
        " --recipe thesis --certify", " --recipe thesis --quality best", " --recipe thesis --bond-length 1.4",
        " --rings 3", " --iterations 10",
        // Files that would be lost.
        " --xyz {out.data}", " --xyz {./out.data}", " --xyz {octahedron.off}", " --xyz ''",
        " --mesh {mesh.xyz}"}) {
    std::string line = build + options;
    if (const auto open = line.find('{'); open != std::string::npos) {
      const std::string name = line.substr(open + 1, line.find('}') - open - 1);
      line = line.substr(0, open) + path(name);
    }
    const Outcome outcome = run(line);
    EXPECT_EQ(outcome.exit_code, 2) << options;
    EXPECT_THAT(outcome.err, testing::StartsWith("nanocarbon: error: ")) << options;
    EXPECT_LT(outcome.err.size(), 300u) << options;
    EXPECT_FALSE(exists("out.data"));
  }
  EXPECT_THAT(run("frobnicate").err, HasSubstr("there is no subcommand 'frobnicate'"));
}

TEST_F(CommandLine, WholeNumbersMayHaveAnExponent) {
  const std::string build = "build " + octahedron() + " --quality draft --quiet -o ";
  ASSERT_EQ(run(build + path("exponent.data") + " --atoms 1e2").exit_code, 0);
  ASSERT_EQ(run(build + path("digits.data") + " --atoms 100").exit_code, 0);
  const auto atoms = [&](const char* file) {  // below the line that repeats the command
    const std::string data = contents(file);
    return data.substr(data.find('\n'));
  };
  EXPECT_EQ(atoms("exponent.data"), atoms("digits.data"));
  ASSERT_EQ(run(build + path("zeros.data") + " --atoms 00100").exit_code, 0);
  EXPECT_EQ(atoms("zeros.data"), atoms("digits.data"));
  for (const std::string number : {"10k", "1.5", "1e", "1e-3"}) {
    const Outcome outcome = run(build + path("none.data") + " --atoms " + number);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("--atoms: '" + number + "' is not a whole number"));
  }
}

TEST_F(CommandLine, WholeNumbersThatDoNotFitAreRefusedAndNotCut) {
  const std::string build = "build " + octahedron() + " --quality draft --atoms 100 --quiet -o ";
  EXPECT_EQ(run(build + path("largest.data") + " --seed 18446744073709551615").exit_code, 0);
  for (const std::string number : {"18446744073709551616", "1e18", "1e400"}) {
    const Outcome outcome = run(build + path("none.data") + " --seed " + number);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("--seed: '" + number + "' is too large"));
  }
}

TEST_F(CommandLine, QuietPrintsNothing) {
  const Outcome outcome =
      run("build " + octahedron() + " --quality draft --atoms 300 --quiet -o " + path("out.data"));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out + outcome.err, "");
}

}  // namespace
}  // namespace nanocarbon::cli
