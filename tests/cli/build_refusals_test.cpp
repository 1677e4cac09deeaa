// SPDX-License-Identifier: GPL-2.0-or-later
// `nanocarbon build` as a user runs it: what it refuses, or warns of.
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <string>

#include "support/program_test.h"

namespace nanocarbon::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

using BuildRefusals = test::ProgramTest;

// A ring too thin for 200 atoms: what is advised is built, and fit finds as much by itself.
TEST_F(BuildRefusals, TheSizeThatARefusalNamesIsBuilt) {
  ASSERT_EQ(run("make mesh torus --major 3 --minor 0.4 -q -o " + path("ring.off")).exit_code, 0);
  const std::string build = "build " + path("ring.off") + " --quality draft -o " + path("out.data");
  const Outcome refused = run(build + " --atoms 200");
  EXPECT_EQ(refused.exit_code, 6);
  EXPECT_THAT(refused.err, HasSubstr("thin part"));
  const auto advice = refused.err.rfind("--atoms ");
  ASSERT_NE(advice, std::string::npos) << refused.err;
  const int atoms = std::stoi(refused.err.substr(advice + 8));
  EXPECT_EQ(run(build + " --atoms " + std::to_string(atoms)).exit_code, 0);
  ASSERT_EQ(run(build + " --atoms fit --report " + path("out.json")).exit_code, 0);
  const auto report = nlohmann::json::parse(contents("out.json"));
  EXPECT_LE(report["options"]["atoms_aimed_at"].get<int>(), 1.3 * atoms);
  // The draft that was found to hold is the one that is written, not a second one.
  const auto below_first_line = [this] {  // which holds the command
    const std::string all = contents("out.data");
    return all.substr(all.find('\n'));
  };
  const std::string fitted = below_first_line();
  EXPECT_EQ(run(build + " --atoms " + report["options"]["atoms_aimed_at"].dump()).exit_code, 0);
  EXPECT_TRUE(below_first_line() == fitted);
  EXPECT_EQ(run(build + " --atoms fit --recipe thesis").exit_code, 2);
  EXPECT_EQ(run(build + " --atoms fits").exit_code, 2);
}

// A cage of 60 atoms is no box: the user who wants it is warned, and fit goes on to one that has the shape.
TEST_F(BuildRefusals, ABoxOfTooFewAtomsIsSaidToBeRoundedOff) {
  const std::string box = file("box.off",
                               "OFF\n8 6 0\n0 0 0\n3 0 0\n3 2 0\n0 2 0\n0 0 1.5\n3 0 1.5\n3 2 1.5\n0 2 1.5\n"
                               "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  const std::string build =
      "build " + box + " --quality draft -o " + path("out.data") + " --report " + path("out.json");
  const Outcome small = run(build + " --atoms 60");
  EXPECT_EQ(small.exit_code, 0);
  EXPECT_THAT(small.err, HasSubstr("rounded off"));
  const Outcome fitted = run(build + " --atoms fit");
  EXPECT_EQ(fitted.exit_code, 0) << fitted.err;
  EXPECT_THAT(fitted.err, Not(HasSubstr("rounded off")));
  const auto report = nlohmann::json::parse(contents("out.json"));
  EXPECT_GT(report["options"]["atoms_aimed_at"].get<int>(), 60);
  EXPECT_LT(report["options"]["atoms_aimed_at"].get<int>(), 1000);
}

// A disc of a fiftieth of its radius needs tens of thousands of atoms: fit names the number instead of taking minutes.
TEST_F(BuildRefusals, FitDoesNotGoOnToHugeMolecules) {
  std::string mesh = "OFF\n64 34 0\n", top = "32", bottom = "32";
  for (const double z : {0.0, 0.02})
    for (int i = 0; i < 32; ++i)
      mesh += std::to_string(std::cos(i * std::numbers::pi / 16)) + " " +
              std::to_string(std::sin(i * std::numbers::pi / 16)) + " " + std::to_string(z) + "\n";
  for (int i = 0; i < 32; ++i) {
    top += " " + std::to_string(32 + i);
    bottom += " " + std::to_string(31 - i);
  }
  mesh += top + "\n" + bottom + "\n";
  for (int i = 0; i < 32; ++i) {
    const int next = (i + 1) % 32;
    mesh += "4 " + std::to_string(i) + " " + std::to_string(next) + " " + std::to_string(32 + next) + " " +
            std::to_string(32 + i) + "\n";
  }
  const Outcome refused = run("build " + file("disc.off", mesh) + " --atoms fit -o " + path("out.data"));
  EXPECT_EQ(refused.exit_code, 6) << refused.err;
  EXPECT_THAT(refused.err, HasSubstr("--atoms fit builds up to 20000"));
  const auto advice = refused.err.rfind("ask for --atoms ");
  ASSERT_NE(advice, std::string::npos) << refused.err;
  EXPECT_GT(std::stoi(refused.err.substr(advice + 16)), 20'000);
}

TEST_F(BuildRefusals, SpecksAreNamedAndLeftOutOnDemand) {
  const std::string mesh = file("specks.off",
                                "OFF\n10 12 0\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n"
                                "5 0 0\n5.01 0 0\n5 0.01 0\n5 0 0.01\n"
                                "3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n"
                                "3 6 8 7\n3 6 7 9\n3 7 8 9\n3 6 9 8\n");
  EXPECT_THAT(run("inspect " + mesh).out, HasSubstr("--drop-specks"));
  const std::string build = "build " + mesh + " --atoms 300 --quality draft -o " + path("out.data");
  const Outcome refused = run(build);
  EXPECT_EQ(refused.exit_code, 6);
  EXPECT_THAT(refused.err, HasSubstr("1 of 2 pieces are specks"));
  ASSERT_EQ(run(build + " --drop-specks --report " + path("out.json")).exit_code, 0);
  const auto report = nlohmann::json::parse(contents("out.json"));
  EXPECT_EQ(report["input"]["pieces"], 1);
  EXPECT_THAT(report["input"]["repairs"].dump(), HasSubstr("dropped specks: 1"));
}

// Two atoms across: the low-pass filter pulls it together.
TEST_F(BuildRefusals, AShapeThatTheThesisLosesIsNotPassedOffAsAMolecule) {
  const std::string needle = file("needle.off",
                                  "OFF\n6 8 0\n60 0 0\n-60 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n"
                                  "3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n");
  const std::string build = "build " + needle + " --recipe thesis --scale 1 -o " + path("out.data");
  const Outcome outcome = run(build);
  EXPECT_EQ(outcome.exit_code, 8);
  EXPECT_THAT(outcome.err, HasSubstr("needle.off: the shape was lost"));
  EXPECT_FALSE(exists("out.data"));
  EXPECT_EQ(run(build + " --force").exit_code, 0);
}

// A ribbon of 110 Angstrom bends at next to no cost: whether eigenvalues of the Hessian were missed below
// those that were found cannot be told.
TEST_F(BuildRefusals, AMoleculeNotShownToBeAtAMinimumIsNotPassedOffAsCertified) {
  constexpr int components = 40;
  std::ostringstream ribbon;
  ribbon << "OFF\n" << 2 * components + 2 << ' ' << 2 * components << " 0\n";
  for (int k = 0; k <= components; ++k)
    for (const int y : {0, 1}) ribbon << 12.0 * k / components << ' ' << y << " 0\n";
  for (int a = 0; a < 2 * components; a += 2) {
    ribbon << "3 " << a << ' ' << a + 2 << ' ' << a + 1 << '\n';
    ribbon << "3 " << a + 1 << ' ' << a + 2 << ' ' << a + 3 << '\n';
  }
  const std::string build = "build " + file("ribbon.off", ribbon.str()) +
                            " --atoms 320 --quality draft --certify -o " + path("ribbon.data") +
                            " --report " + path("ribbon.json");
  const Outcome refused = run(build);
  EXPECT_EQ(refused.exit_code, 8);
  EXPECT_THAT(refused.err, HasSubstr("not shown to be at a minimum"));
  EXPECT_TRUE(exists("ribbon.data"));  // to be looked at
  const auto certificate = nlohmann::json::parse(contents("ribbon.json"))["certificate"];
  EXPECT_FALSE(certificate["minimum"].get<bool>());
  EXPECT_EQ(certificate["complete"].get<bool>(),
            refused.err.find("may have been missed") == std::string::npos);
  EXPECT_EQ(certificate["max_force"].get<double>() < 1e-6,
            refused.err.find("a force of") == std::string::npos);
  EXPECT_EQ(run(build + " --force").exit_code, 0);
}

TEST_F(BuildRefusals, WarnsWhereForcesStayAboveWhatWasAskedFor) {
  const std::string build = "build " + octahedron() + " --quality draft --atoms 200 -o " + path("out.data");
  EXPECT_THAT(run(build + " --max-force 1e-6").err, testing::Not(HasSubstr("largest remaining force")));
  const Outcome beyond_rounding = run(build + " --max-force 1e-16");
  EXPECT_EQ(beyond_rounding.exit_code, 0);
  EXPECT_THAT(beyond_rounding.err, HasSubstr("warning"));
  EXPECT_THAT(beyond_rounding.err, HasSubstr("the largest remaining force is"));
}

TEST_F(BuildRefusals, AnOutputThatCannotBeWrittenLeavesNoneOfTheOthers) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  for (const std::string option : {"--xyz", "--report"})
    EXPECT_EQ(run("build " + octahedron() + " --quality draft --atoms 100 -o " + path("out.data") + " " +
                  option + " /dev/full")
                  .exit_code,
              7);
  EXPECT_FALSE(exists("out.data"));
}

}  // namespace
}  // namespace nanocarbon::cli
