// SPDX-License-Identifier: GPL-2.0-or-later
// `nanocarbon analyse` as a user runs it.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/program_test.h"
#include "support/run_program.h"

namespace nanocarbon::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;

using Analyse = test::ProgramTest;

TEST_F(Analyse, C60HasItsBondsRingsTopologyAndPyramidalisation) {
  const std::string data = path("c60.data");
  ASSERT_EQ(run("make fullerene 1 1 -q -o " + data).exit_code, 0);
  const json c60 = json::parse(run("analyse " + data + " --json").out);
  EXPECT_EQ(c60["atoms"], 60);
  EXPECT_EQ(c60["bonds"]["C-C"]["count"], 90);
  EXPECT_EQ(c60["rings"]["by_size"], json({{"5", 12}, {"6", 20}}));
  EXPECT_EQ(c60["rings"]["atoms"].size(), 32u);
  EXPECT_EQ(c60["euler_characteristic"], 2);
  EXPECT_EQ(c60["pieces"][0]["genus"], 0);
  EXPECT_EQ(c60["hybridisation"]["sp2"], 1.0);
  EXPECT_EQ(c60["defects"]["by_kind"], json({{"pentagon", 12}}));
  EXPECT_NEAR(c60["pyramidalisation"]["mean"], 11.64, 0.1);
  EXPECT_EQ(c60["bonds_of_file"], json({{"count", 90}, {"differing", 0}}));
  const std::string table = run("analyse " + data).out;
  EXPECT_THAT(table, HasSubstr("5: 12, 6: 20"));
  EXPECT_THAT(table, HasSubstr("orientable, genus 0, Euler characteristic 2, 0 boundary loops"));
}

// Every King's ring of C60 is a face; ten primitive ones of 18 atoms go around it.
TEST_F(Analyse, RingsOfSurfacesThatAreSearchedAreCountedPerAtom) {
  const std::string data = path("c60.data");
  ASSERT_EQ(run("make fullerene 1 1 -q -o " + data).exit_code, 0);
  for (const std::string kind : {"king", "primitive"}) {
    const json rings =
        json::parse(run("analyse " + data + " --rings " + kind + " --max-ring 18 --json").out)["rings"];
    EXPECT_EQ(rings["atoms_searched"], 60);
    EXPECT_EQ(rings["king"]["by_size"], json({{"5", 12}, {"6", 20}}));
    EXPECT_NEAR(rings["king"]["per_atom"]["5"], 12.0 / 60, 1e-12);
    EXPECT_EQ(rings["primitive"]["by_size"]["18"], 10);
    EXPECT_NEAR(rings["primitive"]["per_atom"]["18"], 10.0 / 60, 1e-12);
  }
}

// Rows of 3 to 9 squares, as amorphous carbon has clusters of every size.
TEST_F(Analyse, TheTableHasOneLineForManyKindsOfClusters) {
  const std::string xyz = path("ladders.xyz");
  std::ostringstream atoms;
  int count = 0;
  for (int squares = 3; squares <= 9; ++squares)
    for (int k = 0; k <= squares; ++k, count += 2)
      atoms << "C " << 1.45 * k << " " << 10 * squares << " 0\nC " << 1.45 * k << " " << 10 * squares + 1.45
            << " 0\n";
  std::ofstream(xyz) << count << "\n\n" << atoms.str();
  const std::string table = run("analyse " + xyz).out;
  EXPECT_THAT(table, HasSubstr("clusters of rings       7, of 3 to 9 rings each"));
  EXPECT_THAT(table, testing::Not(testing::ContainsRegex("cluster of . rings  ")));
  EXPECT_EQ(json::parse(run("analyse " + xyz + " --json").out)["defects"]["by_kind"]["cluster of 9 rings"],
            1);
}

TEST_F(Analyse, SaysWhatCellItFindsAndWhatIsDoubtfulOfIt) {
  const std::string atoms = "C 0 0 0\nC 1.4 0 0\nC 2.8 0 0.1\n";
  const std::string lattice = "Lattice=\"8 0 0 0 9 0 0 0 10\" Properties=species:S:1:pos:R:3";
  const std::string free = path("free.xyz"), sheet = path("sheet.xyz"), heap = path("heap.xyz");
  std::ofstream(free) << "3\n\n" << atoms;
  std::ofstream(sheet) << "3\n" << lattice << " pbc=\"T T F\"\n" << atoms;
  std::ofstream(heap) << "4\n" << lattice << "\n" << atoms << "C 2.8 0 10\n";
  EXPECT_THAT(run("analyse " + free).out, HasSubstr("none: free space"));
  EXPECT_THAT(run("analyse " + sheet).out, HasSubstr("8 x 9 x 10 A, periodic along a, b\n"));
  const Outcome doubtful = run("analyse " + heap);
  EXPECT_THAT(doubtful.out, HasSubstr("periodic along a, b, c\n"));
  EXPECT_THAT(doubtful.err,
              HasSubstr("atoms 3 and 4 are 0.1 Angstrom from each other across the periodic boundary"));
}

TEST_F(Analyse, OfSeveralFramesComparesEachWithTheFirst) {
  const std::string xyz = path("run.xyz"), csv = path("run.csv"), columns = path("columns.xyz");
  std::ofstream(xyz) << "3\n\nC 0 0 0\nC 1.4 0 0\nC 2.8 0 0\n"
                     << "3\n\nC 0 0 0\nC 1.4 0 0\nC 3.3 0 0\n"  // stretched, not broken
                     << "3\n\nC 0 0 0\nC 1.4 0 0\nC 3.6 0 0\n";
  const Outcome outcome = run("analyse " + xyz + " --json --csv " + csv + " --xyz " + columns);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json found = json::parse(outcome.out);
  ASSERT_EQ(found["frames"].size(), 3u);
  EXPECT_EQ(found["frames"][1]["verdict"], "intact");
  EXPECT_EQ(found["frames"][2]["verdict"], "broken");
  EXPECT_EQ(found["frames"][2]["broken"], json::parse("[[2, 3]]"));
  EXPECT_EQ(found["frames"][2]["repelled"], json::parse("[3]"));
  EXPECT_EQ(found["verdict"], "broken");
  const std::string table = contents(csv);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 4);
  EXPECT_THAT(table, HasSubstr(",broken,1,0,1,0,"));
  const std::string all = contents(columns);
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 15);
  EXPECT_THAT(run("analyse " + xyz).out, HasSubstr("1 bonds broken, 0 formed, 1 atoms repelled"));
  EXPECT_EQ(json::parse(run("analyse " + xyz + " --every 2 --json").out)["frames"].size(), 2u);
}

// Ten hexagons' width of a periodic sheet, as a program writes it that knows no cells.
TEST_F(Analyse, ACellThatTheFileLacksIsTakenFromTheOption) {
  const std::string xyz = path("sheet.xyz"), bare = path("bare.xyz");
  ASSERT_EQ(run("make graphene --cells 6 4 -q -o " + xyz).exit_code, 0);
  ASSERT_EQ(run("make graphene --cells 6 4 -q -o " + path("sheet.data")).exit_code, 0);
  std::ifstream in(xyz);
  std::ofstream out(bare);
  std::string count, comment, lattice;
  std::getline(in, count);
  std::getline(in, comment);
  lattice = comment.substr(comment.find("Lattice=\"") + 9);
  lattice = lattice.substr(0, lattice.find('"'));
  out << count << "\n\n" << in.rdbuf();
  out.close();
  EXPECT_THAT(run("analyse " + bare).out, HasSubstr("have fewer than three bonds"));
  const json found = json::parse(run("analyse " + bare + " --json --cell '" + lattice + "'").out);
  EXPECT_EQ(found["coordination"], json({{"3", std::stoi(count)}}));
  EXPECT_EQ(found["defects"]["count"], 0);
  EXPECT_EQ(run("analyse " + xyz + " --cell '30 30 30'").exit_code, 2);
  EXPECT_EQ(run("analyse " + path("sheet.data") + " --cell '30 30 30'").exit_code, 2);
  for (const char* wrong : {"30 30", "30 30 x", "30 30 18.5 -", "0.02 0.02 0.02", "30 30 0", "1 2 3 4 5 6"})
    EXPECT_EQ(run("analyse " + bare + " --cell '" + wrong + "'").exit_code, 2) << wrong;
}

// C60 without IDs that loses its tenth atom: three bonds are broken and no other atom is lost.
TEST_F(Analyse, AtomsWithoutIdsThatVanishAreToldByPlace) {
  const std::string written = path("c60.xyz"), xyz = path("two.xyz");
  ASSERT_EQ(run("make fullerene 1 1 -q -o " + written).exit_code, 0);
  std::ifstream in(written);
  std::vector<std::string> atoms;
  std::string line;
  for (int k = 0; std::getline(in, line); ++k)
    if (k >= 2) {
      std::istringstream words(line);
      std::string element, x, y, z;
      words >> element >> x >> y >> z;
      atoms.push_back(element + " " + x + " " + y + " " + z + "\n");
    }
  ASSERT_EQ(atoms.size(), 60u);
  std::ofstream out(xyz);
  for (const bool whole : {true, false}) {
    out << (whole ? 60 : 59) << "\n\n";
    for (std::size_t a = 0; a < atoms.size(); ++a)
      if (whole || a != 9) out << atoms[a];
  }
  out.close();
  const auto said = run("analyse " + xyz + " --json");
  const json last = json::parse(said.out)["frames"][1];
  EXPECT_EQ(last["lost"], json({10}));
  EXPECT_EQ(last["broken"].size(), 3u);
  EXPECT_EQ(last["formed"].size(), 0u);
  EXPECT_THAT(said.err, HasSubstr("have no IDs"));
  EXPECT_THAT(run("analyse " + xyz).out, HasSubstr("frame 2: 3 bonds broken, 0 formed, 1 atoms lost"));
}

TEST_F(Analyse, AMeshThatItWritesBuildsTheMoleculeAgain) {
  const std::string data = path("c240.data"), mesh = path("c240.off"), again = path("again.data");
  ASSERT_EQ(run("make fullerene 2 2 -q -o " + data).exit_code, 0);
  ASSERT_EQ(run("analyse " + data + " -q --mesh " + mesh).exit_code, 0);
  const Outcome built = run("build " + mesh + " --scale 1 --recipe thesis --iterations 0 -q -o " + again);
  ASSERT_EQ(built.exit_code, 0) << built.err;
  const json a = json::parse(run("analyse --json " + data).out),
             b = json::parse(run("analyse --json " + again).out);
  EXPECT_EQ(a["rings"]["by_size"], b["rings"]["by_size"]);
}

TEST_F(Analyse, AMeshOfAPeriodicMoleculeIsInItsCell) {
  const std::string data = path("p688.data"), mesh = path("p688.off");
  ASSERT_EQ(run("make schwarzite p688 --cells 2 -q -o " + data).exit_code, 0);
  ASSERT_EQ(run("analyse " + data + " -q --mesh " + mesh).exit_code, 0);
  const json found = json::parse(run("inspect " + mesh + " --json").out);
  // Euler characteristic -4 a cell (O'Keeffe, Adams and Sankey 1992), eight cells, no boundary.
  EXPECT_EQ(found["cell"]["euler_characteristic"], -32);
  EXPECT_EQ(found["cell"]["boundary_loops"], 0);
  EXPECT_EQ(run("analyse " + data + " -q --mesh " + path("p688.stl")).exit_code, 2);
}

// Names of files may be any bytes; JSON is UTF-8.
TEST_F(Analyse, JsonIsValidWhateverTheNameOfTheFile) {
  const std::string named = file("caf\xe9 \"quoted\" \x01.xyz", "2\n\nC 0 0 0\nC 1.4 0 0\n");
  const Outcome outcome = run("analyse --json '" + named + "'");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json found = json::parse(outcome.out);
  EXPECT_EQ(found["atoms"], 2);
  EXPECT_THAT(found["frames"][0]["file"].get<std::string>(), HasSubstr("\"quoted\" \x01"));
}

TEST_F(Analyse, JsonThatCannotBeWrittenIsSaid) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  const std::string two = file("two.xyz", "2\n\nC 0 0 0\nC 1.4 0 0\n");
  const test::ProgramOutcome outcome =
      test::run_command("(" NANOCARBON_PROGRAM " analyse --json " + two + " >/dev/full)");
  EXPECT_EQ(outcome.exit_code, 7);
  EXPECT_THAT(outcome.output, HasSubstr("standard output"));
}

// As LAMMPS writes by default: types without elements, atoms in any order.
TEST_F(Analyse, TypesAndFilesMayStandInAnyOrder) {
  const std::string first = path("first.lammpstrj"), second = path("second.lammpstrj");
  for (const std::string& dump : {first, second})
    std::ofstream(dump)
        << "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS ff ff ff\n0 9\n0 9\n0 9\n"
           "ITEM: ATOMS type z y x id\n1 0 0 2.8 3\n1 0 0 0 1\n1 0 0 1.4 2\n";
  for (const std::string& order :
       {first + " " + second + " --types C", "--types C H " + first + " " + second,
        first + " --types C " + second, "--types 1=C " + first + " " + second + " --every 1"}) {
    const json found = json::parse(run("analyse --json -q " + order).out);
    EXPECT_EQ(found["frames"].size(), 2u) << order;
    EXPECT_EQ(found["bonds"]["C-C"]["count"], 2) << order;
  }
  EXPECT_EQ(run("analyse --types C").exit_code, 2);
  EXPECT_EQ(run("analyse --types C " + path("nowhere.xyz")).exit_code, 3);
  EXPECT_THAT(run("analyse " + first).err, HasSubstr("--types"));
}

TEST_F(Analyse, SaysWhatIsWrongAndExitsWithItsCode) {
  const std::string data = path("sheet.data");
  ASSERT_EQ(run("make graphene --cells 2 2 -q -o " + data).exit_code, 0);
  const Outcome narrow = run("analyse " + data + " --mesh " + path("sheet.off"));
  EXPECT_EQ(narrow.exit_code, 5);
  EXPECT_THAT(narrow.err, HasSubstr("repeat the cell first"));
  EXPECT_FALSE(exists("sheet.off"));
  EXPECT_EQ(run("analyse " + data + " --form 2.1").exit_code, 2);
  EXPECT_EQ(run("analyse " + data + " --mesh " + path("sheet.png")).exit_code, 2);
  EXPECT_EQ(run("analyse " + path("nowhere.data")).exit_code, 3);
  EXPECT_EQ(run("analyse " + file("empty.xyz", "0\n\n")).exit_code, 5);
}

}  // namespace
}  // namespace nanocarbon::cli
