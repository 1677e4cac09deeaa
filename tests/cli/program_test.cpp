// SPDX-License-Identifier: GPL-2.0-or-later
// Runs the program as a user does: exit codes, messages, files.
#include <gmock/gmock.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <utility>

namespace nanocarbon::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct Outcome {
  int exit_code;
  std::string out;
  std::string err;
};

class Program : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder = fs::path(testing::TempDir()) / (std::string("nanocarbon_program_") + test->name());
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  Outcome run(const std::string& arguments) const {
    const fs::path out = folder / ".out", err = folder / ".err";
    const std::string line = std::string(NANOCARBON_PROGRAM) + " " + arguments + " >" + out.string() + " 2>" +
                             err.string() + " </dev/null";
    const int status = std::system(line.c_str());
    const Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(out), contents(err)};
    fs::remove(out);
    fs::remove(err);
    return outcome;
  }

  static std::string contents(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name, std::ios::binary) << text;
    return (folder / name).string();
  }
  std::string path(const std::string& name) const { return (folder / name).string(); }

  // An octahedron: 6 vertices, 8 faces.
  std::string octahedron() const {
    return file("octahedron.off",
                "OFF\n6 8 0\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n"
                "3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n");
  }

  fs::path folder;
};

TEST_F(Program, HelpAndVersionSucceed) {
  EXPECT_EQ(run("--help").exit_code, 0);
  EXPECT_EQ(run("--version").exit_code, 0);
  for (const std::string subcommand : {"inspect", "build"}) {
    const Outcome help = run(subcommand + " --help");
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_THAT(help.out, HasSubstr("Examples:"));
  }
}

TEST_F(Program, EachKindOfFailureHasItsExitCodeAndLeavesNoFile) {
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
  EXPECT_EQ(build(folder.string()).exit_code, 3);
  EXPECT_EQ(build(truncated).exit_code, 4);
  EXPECT_EQ(build(moebius_edge).exit_code, 5);
  EXPECT_EQ(build(sound).exit_code, 6);
  EXPECT_EQ(build(sound + " --atoms 1000000000000000").exit_code, 6);
  EXPECT_EQ(build(sound + " --atoms 3900000000").exit_code, 6);  // more than a terabyte
  EXPECT_EQ(run("build " + sound + " --atoms 100 -o " + path("none/out.data")).exit_code, 7);
  EXPECT_FALSE(fs::exists(path("out.data")));
}

TEST_F(Program, WarnsWhereForcesStayAboveWhatWasAskedFor) {
  const std::string build = "build " + octahedron() + " --quality draft --atoms 200 -o " + path("out.data");
  EXPECT_THAT(run(build + " --max-force 1e-6").err, testing::Not(HasSubstr("largest force")));
  const Outcome beyond_rounding = run(build + " --max-force 1e-16");
  EXPECT_EQ(beyond_rounding.exit_code, 0);
  EXPECT_THAT(beyond_rounding.err, HasSubstr("warning"));
  EXPECT_THAT(beyond_rounding.err, HasSubstr("the largest force left is"));
}

// A ribbon of 110 Angstrom bends at next to no cost: whether eigenvalues of the Hessian were missed below
// those that were found cannot be told.
TEST_F(Program, AMoleculeNotShownToBeAtAMinimumIsNotPassedOffAsCertified) {
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
                            " --atoms 400 --quality draft --certify -o " + path("ribbon.data") +
                            " --report " + path("ribbon.json");
  const Outcome refused = run(build);
  EXPECT_EQ(refused.exit_code, 8);
  EXPECT_THAT(refused.err, HasSubstr("not shown to be at a minimum"));
  EXPECT_TRUE(fs::exists(path("ribbon.data")));  // to be looked at
  const auto certificate = nlohmann::json::parse(contents(path("ribbon.json")))["certificate"];
  EXPECT_FALSE(certificate["minimum"].get<bool>());
  EXPECT_EQ(certificate["complete"].get<bool>(),
            refused.err.find("may have been missed") == std::string::npos);
  EXPECT_EQ(certificate["max_force"].get<double>() < 1e-6,
            refused.err.find("a force of") == std::string::npos);
  EXPECT_EQ(run(build + " --force").exit_code, 0);
}

TEST_F(Program, WholeNumbersMayHaveAnExponent) {
  const std::string build = "build " + octahedron() + " --quality draft --quiet -o ";
  ASSERT_EQ(run(build + path("exponent.data") + " --atoms 1e2").exit_code, 0);
  ASSERT_EQ(run(build + path("digits.data") + " --atoms 100").exit_code, 0);
  const auto atoms = [&](const char* file) {  // below the line that repeats the command
    const std::string data = contents(path(file));
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

TEST_F(Program, WholeNumbersThatDoNotFitAreRefusedAndNotCut) {
  const std::string build = "build " + octahedron() + " --quality draft --atoms 100 --quiet -o ";
  EXPECT_EQ(run(build + path("largest.data") + " --seed 18446744073709551615").exit_code, 0);
  for (const std::string number : {"18446744073709551616", "1e18", "1e400"}) {
    const Outcome outcome = run(build + path("none.data") + " --seed " + number);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("--seed: '" + number + "' is too large"));
  }
}

TEST_F(Program, OptionsThatMakeNoSenseAreRefusedBeforeAnyWork) {
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
    EXPECT_FALSE(fs::exists(path("out.data")));
  }
  EXPECT_THAT(run("frobnicate").err, HasSubstr("there is no subcommand 'frobnicate'"));
}

TEST_F(Program, AnOutputThatCannotBeWrittenLeavesNoneOfTheOthers) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  for (const std::string option : {"--xyz", "--report"})
    EXPECT_EQ(run("build " + octahedron() + " --quality draft --atoms 100 -o " + path("out.data") + " " +
                  option + " /dev/full")
                  .exit_code,
              7);
  EXPECT_FALSE(fs::exists(path("out.data")));
}

// Two atoms across: the low-pass filter pulls it together.
TEST_F(Program, AShapeThatTheThesisLosesIsNotPassedOffAsAMolecule) {
  const std::string needle = file("needle.off",
                                  "OFF\n6 8 0\n60 0 0\n-60 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n"
                                  "3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n");
  const std::string build = "build " + needle + " --recipe thesis --scale 1 -o " + path("out.data");
  const Outcome outcome = run(build);
  EXPECT_EQ(outcome.exit_code, 8);
  EXPECT_THAT(outcome.err, HasSubstr("needle.off: the shape was lost"));
  EXPECT_FALSE(fs::exists(path("out.data")));
  EXPECT_EQ(run(build + " --force").exit_code, 0);
}

// The molecule of an open shape has its boundary too: as many boundary loops, and a triangle for each atom.
TEST_F(Program, ReportsTheTopologyOfOpenShapes) {
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
    const auto molecule = nlohmann::json::parse(contents(path("out.json")))["molecule"];
    EXPECT_EQ(molecule["pieces"], 1);
    EXPECT_EQ(molecule["boundary_loops"], 1);
    EXPECT_EQ(molecule["euler_characteristic"], 1);
    EXPECT_EQ(molecule["genus"], 0);
    const auto mesh = nlohmann::json::parse(run("inspect --json " + path("out.ply")).out);
    EXPECT_EQ(mesh["faces"], molecule["atoms"]);
  }
}

TEST_F(Program, MessagesNameTheFileAndThePlace) {
  const std::string bad = file("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n");
  const Outcome outcome = run("build " + bad + " -o " + path("out.data"));
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("bad.off:5"));
}

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

TEST_F(Program, BuildsAClosedCageByTheThesis) {
  const Outcome outcome =
      run("build " + octahedron() + " --recipe thesis --projection-interval 0 --atoms 400 -o " +
          path("out.data") + " --xyz " + path("out.xyz") + " --mesh " + path("out.ply") + " --report " +
          path("out.json"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto report = nlohmann::json::parse(contents(path("out.json")));
  expect_a_closed_cage(report, 400);
  const long atoms = report["molecule"]["atoms"], rings = report["molecule"]["rings"];
  const std::string data = contents(path("out.data"));
  EXPECT_THAT(data, HasSubstr(std::to_string(atoms) + " atoms"));
  // The first line tells how to make it again.
  EXPECT_THAT(data.substr(0, data.find('\n')),
              testing::AllOf(HasSubstr("nanocarbon build"), HasSubstr("--recipe thesis"),
                             HasSubstr("--atoms 400"), HasSubstr("--projection-interval 0")));
  EXPECT_TRUE(contents(path("out.xyz")).starts_with(std::to_string(atoms) + "\n"));
  // The triangulation in the file is what the molecule is the dual of.
  const auto mesh = nlohmann::json::parse(run("inspect --json " + path("out.ply")).out);
  EXPECT_EQ(mesh["faces"], atoms);
  EXPECT_EQ(mesh["vertices"], rings);
}

TEST_F(Program, TheThesisMeetsTheNumberOfAtomsThoughTheSurfaceShrinks) {
  const Outcome outcome =
      run("build " + octahedron() + " --recipe thesis --projection-interval 10 --atoms 4000 -q -o " +
          path("out.data") + " --report " + path("out.json"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto report = nlohmann::json::parse(contents(path("out.json")));
  EXPECT_NEAR(report["molecule"]["atoms"].get<double>(), 4000, 120);
}

TEST_F(Program, BuildsAMoleculeAtAMinimumWithNothingToTune) {
  const Outcome outcome =
      run("build " + octahedron() + " --quality draft --atoms 240 -o " + path("out.data") + " --mesh " +
          path("out.ply") + " --report " + path("out.json"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto report = nlohmann::json::parse(contents(path("out.json")));
  expect_a_closed_cage(report, 240);
  EXPECT_GT(report["bond_lengths"]["min"], 1.3);
  EXPECT_LT(report["bond_lengths"]["max"], 1.6);
  EXPECT_LT(report["annealing"]["max_force"], 1e-3);
  // The icosahedral C240 has -7.2050937785 eV an atom, and nothing of its size is known to have less.
  EXPECT_GT(report["annealing"]["energy_per_atom"], -7.2051 - 0.01);
  const auto mesh = nlohmann::json::parse(run("inspect --json " + path("out.ply")).out);
  EXPECT_EQ(mesh["faces"], report["molecule"]["atoms"]);
}

TEST_F(Program, SameInputAndSeedGiveTheSameBytes) {
  const std::string mesh = octahedron();
  for (const std::string name : {"a", "b"})
    ASSERT_EQ(run("build " + mesh + " --quality draft --atoms 300 --seed 7 --quiet -o " + path("out.data") +
                  " --xyz " + path(name + ".xyz"))
                  .exit_code,
              0);
  const auto body = [&](const std::string& name) {
    const std::string text = contents(path(name));
    return text.substr(text.find('\n', text.find('\n') + 1));  // the second line holds the command
  };
  EXPECT_EQ(body("a.xyz"), body("b.xyz"));
  EXPECT_GT(body("a.xyz").size(), 1000u);
}

TEST_F(Program, PrintsItsHelpWhenNothingIsAskedOfIt) {
  const Outcome outcome = run("");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, run("--help").out);
  for (const char* subcommand : {"inspect", "build", "make", "energy"})
    EXPECT_THAT(outcome.out, HasSubstr(subcommand));
}

// A closed and an open molecule that are annealed, and the thesis's recipe, which uses threads from 20,000
// points on.
TEST_F(Program, TheNumberOfThreadsChangesNoByte) {
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
      const std::string all =
          contents(path("out.data")) + contents(path("out.xyz")) + contents(path("out.ply"));
      ASSERT_GT(all.size(), 10000u);
      if (first.empty()) first = all;
      EXPECT_TRUE(all == first) << options << threads;
    }
  }
}

// OpenMP's threads introduce themselves; without being told it would take as many as there are cores.
TEST_F(Program, UsesAsManyThreadsAsItIsAllowed) {
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

TEST_F(Program, QuietPrintsNothing) {
  const Outcome outcome =
      run("build " + octahedron() + " --quality draft --atoms 300 --quiet -o " + path("out.data"));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out + outcome.err, "");
}

TEST_F(Program, InspectTellsWhatAMeshIs) {
  const auto json = nlohmann::json::parse(run("inspect --json " + octahedron()).out);
  EXPECT_EQ(json["vertices"], 6);
  EXPECT_EQ(json["faces"], 8);
  EXPECT_EQ(json["euler_characteristic"], 2);
  EXPECT_EQ(json["genus"], 0);
  EXPECT_EQ(json["usable"], true);
}

TEST_F(Program, InspectNamesEveryReasonAgainstAMesh) {
  // Three faces at edge 0-1, and a face that repeats a vertex (which alone would be dropped).
  const std::string mesh =
      file("bad.off", "OFF\n5 4 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n3 0 1 2\n3 1 0 3\n3 0 1 4\n3 2 2 3\n");
  const Outcome outcome = run("inspect --json " + mesh);
  EXPECT_EQ(outcome.exit_code, 5);
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["usable"], false);
  ASSERT_FALSE(json["reasons"].empty());
  EXPECT_EQ(json["reasons"][0]["problem"], "non_manifold_edge");
}

// The square of each side with vertices of its own, as programs write boxes with textures or flat normals.
TEST_F(Program, InspectTellsWhatBuildTakes) {
  std::string box = "OFF\n24 6 0\n";
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {0, 1})
      for (const auto& [u, v] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
        std::array<int, 3> p{};
        p[axis] = side;
        p[(axis + 1) % 3] = side ? u : v;
        p[(axis + 2) % 3] = side ? v : u;
        box += std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
      }
  for (int face = 0; face < 24; face += 4)
    box += "4 " + std::to_string(face) + " " + std::to_string(face + 1) + " " + std::to_string(face + 2) +
           " " + std::to_string(face + 3) + "\n";
  const auto json = nlohmann::json::parse(run("inspect --json " + file("box.off", box)).out);
  EXPECT_EQ(json["as_read"]["vertices"], 24);
  EXPECT_EQ(json["vertices"], 8);
  EXPECT_EQ(json["pieces"], 1);
  EXPECT_EQ(json["boundary_loops"], 0);
  EXPECT_NEAR(json["volume"], 1.0, 1e-12);
  const Outcome refused = run("build " + path("box.off") + " --no-repair -o " + path("out.data"));
  EXPECT_EQ(refused.exit_code, 5);
  EXPECT_THAT(refused.err, HasSubstr("--no-repair"));
  EXPECT_THAT(refused.err, HasSubstr("joined vertices to others at the same place: 16"));
}

TEST_F(Program, SpecksAreNamedAndLeftOutOnDemand) {
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
  const auto report = nlohmann::json::parse(contents(path("out.json")));
  EXPECT_EQ(report["input"]["pieces"], 1);
  EXPECT_THAT(report["input"]["repairs"].dump(), HasSubstr("dropped specks: 1"));
}

// A ring too thin for 200 atoms: what is advised is built, and fit finds as much by itself.
TEST_F(Program, TheSizeThatARefusalNamesIsBuilt) {
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
  const auto report = nlohmann::json::parse(contents(path("out.json")));
  EXPECT_LE(report["options"]["atoms_aimed_at"].get<int>(), 1.3 * atoms);
  EXPECT_EQ(run(build + " --atoms fit --recipe thesis").exit_code, 2);
  EXPECT_EQ(run(build + " --atoms fits").exit_code, 2);
}

}  // namespace
}  // namespace nanocarbon::cli
