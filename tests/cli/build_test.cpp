// SPDX-License-Identifier: GPL-2.0-or-later
// `nanocarbon build` as a user runs it: what it makes.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "support/program_test.h"

namespace nanocarbon::cli {
namespace {

using testing::HasSubstr;

using Build = test::ProgramTest;

// Euler's formula and the handshakes of atoms, bonds and rings, on the report and on the files.
void expect_a_closed_cage(const nlohmann::json& report, long aimed_at) {
  const auto& molecule = report["molecule"];
  const long atoms = molecule["atoms"], bonds = molecule["bonds"], rings = molecule["rings"];
  EXPECT_EQ(atoms - bonds + rings, 2);
  EXPECT_EQ(2 * bonds, 3 * atoms);
  EXPECT_EQ(molecule["genus"], 0);
  EXPECT_NEAR(static_cast<double>(atoms), static_cast<double>(aimed_at), 0.1 * static_cast<double>(aimed_at));
  long sides = 0, counted = 0;
  for (const auto& [size, count] : molecule["rings_by_size"].items()) {
    counted += count.get<long>();
    sides += std::stol(size) * count.get<long>();
  }
  EXPECT_EQ(counted, rings);
  EXPECT_EQ(sides, 2 * bonds);
}

TEST_F(Build, BuildsAClosedCageByTheThesis) {
  const Outcome outcome =
      run("build " + octahedron() + " --recipe thesis --projection-interval 0 --atoms 400 -o " +
          path("out.data") + " --xyz " + path("out.xyz") + " --mesh " + path("out.ply") + " --report " +
          path("out.json"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto report = nlohmann::json::parse(contents("out.json"));
  expect_a_closed_cage(report, 400);
  const long atoms = report["molecule"]["atoms"], rings = report["molecule"]["rings"];
  const std::string data = contents("out.data");
  EXPECT_THAT(data, HasSubstr(std::to_string(atoms) + " atoms"));
  // The first line tells how to make it again.
  EXPECT_THAT(data.substr(0, data.find('\n')),
              testing::AllOf(HasSubstr("nanocarbon build"), HasSubstr("--recipe thesis"),
                             HasSubstr("--atoms 400"), HasSubstr("--projection-interval 0")));
  EXPECT_TRUE(contents("out.xyz").starts_with(std::to_string(atoms) + "\n"));
  // The triangulation in the file is what the molecule is the dual of.
  const auto mesh = nlohmann::json::parse(run("inspect --json " + path("out.ply")).out);
  EXPECT_EQ(mesh["faces"], atoms);
  EXPECT_EQ(mesh["vertices"], rings);
}

TEST_F(Build, TheThesisMeetsTheNumberOfAtomsThoughTheSurfaceShrinks) {
  const Outcome outcome =
      run("build " + octahedron() + " --recipe thesis --projection-interval 10 --atoms 4000 -q -o " +
          path("out.data") + " --report " + path("out.json"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto report = nlohmann::json::parse(contents("out.json"));
  EXPECT_NEAR(report["molecule"]["atoms"].get<double>(), 4000, 120);
}

TEST_F(Build, BuildsAMoleculeAtAMinimumWithNothingToTune) {
  const Outcome outcome =
      run("build " + octahedron() + " --quality draft --atoms 240 -o " + path("out.data") + " --mesh " +
          path("out.ply") + " --report " + path("out.json"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto report = nlohmann::json::parse(contents("out.json"));
  expect_a_closed_cage(report, 240);
  EXPECT_GT(report["bond_lengths"]["min"], 1.3);
  EXPECT_LT(report["bond_lengths"]["max"], 1.6);
  EXPECT_LT(report["annealing"]["max_force"], 1e-3);
  // The icosahedral C240 has -7.2050937785 eV an atom, and nothing of its size is known to have less.
  EXPECT_GT(report["annealing"]["energy_per_atom"], -7.2051 - 0.01);
  const auto mesh = nlohmann::json::parse(run("inspect --json " + path("out.ply")).out);
  EXPECT_EQ(mesh["faces"], report["molecule"]["atoms"]);
}

// The molecule of an open shape has its boundary too: as many boundary loops, and a triangle for each atom.
TEST_F(Build, ReportsTheTopologyOfOpenShapes) {
  std::string strip = "OFF\n42 40 0\n";
  for (int i = 0; i < 21; ++i)
    for (int j = 0; j < 2; ++j) strip += std::to_string(i) + " " + std::to_string(2 * j) + " 0\n";
  for (int i = 0; i < 40; i += 2)
    strip += "3 " + std::to_string(i) + " " + std::to_string(i + 2) + " " + std::to_string(i + 1) + "\n3 " +
             std::to_string(i + 1) + " " + std::to_string(i + 2) + " " + std::to_string(i + 3) + "\n";
  for (const std::string recipe : {"thesis", "annealed --quality draft"}) {
    const Outcome outcome =
        run("build " + file("strip.off", strip) + " --recipe " + recipe + " --atoms 300 -o " +
            path("out.data") + " --mesh " + path("out.ply") + " --report " + path("out.json"));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto molecule = nlohmann::json::parse(contents("out.json"))["molecule"];
    EXPECT_EQ(molecule["pieces"], 1);
    EXPECT_EQ(molecule["boundary_loops"], 1);
    EXPECT_EQ(molecule["euler_characteristic"], 1);
    EXPECT_EQ(molecule["genus"], 0);
    const auto mesh = nlohmann::json::parse(run("inspect --json " + path("out.ply")).out);
    EXPECT_EQ(mesh["faces"], molecule["carbon"]);
  }
}

TEST_F(Build, SameInputAndSeedGiveTheSameBytes) {
  const std::string mesh = octahedron();
  for (const std::string name : {"a", "b"})
    ASSERT_EQ(run("build " + mesh + " --quality draft --atoms 300 --seed 7 --quiet -o " + path("out.data") +
                  " --xyz " + path(name + ".xyz"))
                  .exit_code,
              0);
  const auto body = [&](const std::string& name) {
    const std::string text = contents(name);
    return text.substr(text.find('\n', text.find('\n') + 1));  // the second line holds the command
  };
  EXPECT_EQ(body("a.xyz"), body("b.xyz"));
  EXPECT_GT(body("a.xyz").size(), 1000u);
}

// A closed and an open molecule that are annealed, and the thesis's recipe, which uses threads from 20,000
// points on.
TEST_F(Build, TheNumberOfThreadsChangesNoByte) {
  const std::string cup = file("cup.off",
                               "OFF\n6 6 0\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n"
                               "3 2 1 4\n3 1 3 4\n3 3 0 4\n3 1 2 5\n3 3 1 5\n3 0 3 5\n");
  ASSERT_EQ(run("make mesh sphere --subdivisions 46 -q -o " + path("sphere.off")).exit_code, 0);
  for (const std::string& options : {octahedron() + " --atoms 200", cup + " --atoms 300 --quality good",
                                     path("sphere.off") + " --recipe thesis --iterations 3"}) {
    std::string first;
    for (const std::string threads : {" --threads 1", " --threads 2", " --threads 3", ""}) {
      const Outcome outcome = run("build " + options + threads + " -q -o " + path("out.data") + " --xyz " +
                                  path("out.xyz") + " --mesh " + path("out.ply"));
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
      const std::string all = contents("out.data") + contents("out.xyz") + contents("out.ply");
      ASSERT_GT(all.size(), 10000u);
      if (first.empty()) first = all;
      EXPECT_TRUE(all == first) << options << threads;
    }
  }
}

// OpenMP's threads introduce themselves; without being told it would take as many as there are cores.
TEST_F(Build, UsesAsManyThreadsAsItIsAllowed) {
  setenv("OMP_DISPLAY_AFFINITY", "TRUE", 1);
  setenv("OMP_AFFINITY_FORMAT", "openmp thread %n", 1);
  const std::string build =
      "build " + octahedron() + " --atoms 100 --quality draft -q -o " + path("out.data");
  const Outcome one = run(build + " --threads 1"), two = run(build + " --threads 2"), all = run(build);
  unsetenv("OMP_DISPLAY_AFFINITY");
  unsetenv("OMP_AFFINITY_FORMAT");
  EXPECT_THAT(two.err, HasSubstr("openmp thread 1"));
  EXPECT_THAT(one.err, testing::Not(HasSubstr("openmp thread 1")));
  if (std::thread::hardware_concurrency() > 1) {
    EXPECT_THAT(all.err, HasSubstr("openmp thread 1"));
  }
}

}  // namespace
}  // namespace nanocarbon::cli
