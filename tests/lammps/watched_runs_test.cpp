// SPDX-License-Identifier: GPL-2.0-or-later
//! \file
//! \brief fix bond/topology in dynamics: the file says what the library computes from the trajectory, and
//! says the same however the run is made.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lammps/lammps_run.h"
#include "lammps/offline_watch.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/tube.h"

namespace nanocarbon {
namespace {

using nlohmann::json;
using test::LammpsRun;
using test::SharedFolder;

using Commands = std::vector<std::string>;

const std::string all_digits = "%d %d %.17g %.17g %.17g";

// So hot that bonds break within a picosecond.
void heat(LammpsRun& run, double temperature) {
  const std::string kelvin = std::to_string(temperature);
  run.commands({"velocity all create " + kelvin + " 4711 loop geom", "fix move all nve",
                "fix heat all temp/rescale 1 " + kelvin + " " + kelvin + " 10 1.0"});
}

void dump_every_look(LammpsRun& run, const std::string& path, int every) {
  run.commands({"dump frames all custom " + std::to_string(every) + " " + path + " id type x y z",
                "dump_modify frames format line \"" + all_digits + "\""});
}

std::vector<json> lines_of_file(const std::string& path) { return test::parsed(test::lines_of(path)); }

// What is in the file of a hot C60 after 600 steps made by the given commands. The same trajectory every time
// on the same number of ranks.
std::vector<json> hot_ball(const Commands& after_box, const Commands& commands) {
  const SharedFolder folder;
  LammpsRun run;
  run.read(structures::fullerene(1, 1), "rebo", after_box);
  heat(run, 5500);
  run.command("fix watch all bond/topology 10 file " + folder / "changes.jsonl");
  run.commands(commands);
  return lines_of_file(folder / "changes.jsonl");
}

TEST(WatchedRun, EveryChangeOfAHotFullereneIsWhatTheLibraryComputesFromTheTrajectory) {
  const SharedFolder folder;
  LammpsRun run;
  run.read(structures::fullerene(1, 1));
  heat(run, 5500);
  run.command("fix watch all bond/topology 5 file " + folder / "changes.jsonl");
  dump_every_look(run, folder / "frames", 5);
  run.command("run 1500 post no");
  run.command("undump frames");
  const auto changes = lines_of_file(folder / "changes.jsonl");
  ASSERT_GT(changes.size(), 10u) << "the run is to be so hot that bonds break";
  EXPECT_EQ(changes, test::expected_lines(test::read_trajectory(folder / "frames", {false, false, false})));
}

TEST(WatchedRun, EveryChangeOfAHotPeriodicTubeIsWhatTheLibraryComputesFromTheTrajectory) {
  const SharedFolder folder;
  LammpsRun run;
  run.read(structures::periodic_tube(5, 5, 8));
  heat(run, 5500);
  run.command("fix watch all bond/topology 5 file " + folder / "changes.jsonl");
  dump_every_look(run, folder / "frames", 5);
  run.command("run 1000 post no");
  run.command("undump frames");
  const auto changes = lines_of_file(folder / "changes.jsonl");
  ASSERT_GT(changes.size(), 10u);
  EXPECT_EQ(changes, test::expected_lines(test::read_trajectory(folder / "frames", {false, false, true})));
}

TEST(WatchedRun, ARerunOfTheTrajectorySaysTheSame) {
  const SharedFolder folder;
  const auto changes =
      hot_ball({}, {"dump frames all custom 10 " + folder / "frames" + " id type x y z",
                    "dump_modify frames format line \"" + all_digits + "\"", "run 600 post no"});
  ASSERT_GT(changes.size(), 3u);
  LammpsRun run;
  run.read(structures::fullerene(1, 1));
  run.commands({"fix watch all bond/topology 10 file " + folder / "again.jsonl",
                "rerun " + folder / "frames" + " post no dump x y z"});
  EXPECT_EQ(lines_of_file(folder / "again.jsonl"), changes);
}

TEST(WatchedRun, ARunInPiecesSaysTheSame) {
  const auto changes = hot_ball({}, {"run 600 post no"});
  ASSERT_GT(changes.size(), 3u);
  EXPECT_EQ(hot_ball({}, {"run 137 post no", "run 163 pre no post no", "run 300 pre no post no"}), changes);
  EXPECT_EQ(hot_ball({}, {"run 600 post no every 97 NULL"}), changes);
}

TEST(WatchedRun, SortingAtomsChangesNothing) {
  const auto changes = hot_ball({"atom_modify sort 0 0"}, {"run 600 post no"});
  ASSERT_GT(changes.size(), 3u);
  EXPECT_EQ(hot_ball({"atom_modify sort 20 3.0"}, {"run 600 post no"}).front(), changes.front());
  // Sorting changes the order of sums, so the trajectory; what is said of it must still be right.
  const SharedFolder folder;
  LammpsRun run;
  run.read(structures::fullerene(1, 1), "rebo", {"atom_modify sort 20 3.0"});
  heat(run, 5500);
  run.command("fix watch all bond/topology 10 file " + folder / "changes.jsonl");
  dump_every_look(run, folder / "frames", 10);
  run.command("run 600 post no");
  run.command("undump frames");
  EXPECT_EQ(lines_of_file(folder / "changes.jsonl"),
            test::expected_lines(test::read_trajectory(folder / "frames", {false, false, false})));
}

TEST(WatchedRun, SeveralFixesDoNotDisturbEachOther) {
  const SharedFolder folder;
  const auto changes = hot_ball(
      {}, {"group half id 1:30", "fix second half bond/topology 3 file " + folder / "half.jsonl",
           "fix third all bond/topology 10 maxring 9 file " + folder / "third.jsonl", "run 600 post no"});
  EXPECT_EQ(changes, hot_ball({}, {"run 600 post no"}));
  const auto third = lines_of_file(folder / "third.jsonl");
  ASSERT_EQ(third.size(), changes.size());
  for (std::size_t k = 1; k < third.size(); ++k) {
    EXPECT_EQ(third[k]["broken"], changes[k]["broken"]);
    EXPECT_EQ(third[k]["formed"], changes[k]["formed"]);
  }
  for (const json& line : lines_of_file(folder / "half.jsonl"))
    for (const char* const list : {"broken", "formed"})
      for (const json& bond : line.value(list, json::array())) EXPECT_LE(bond[1], 30);
}

TEST(WatchedRun, ARestartGoesOnFromTheSameStart) {
  const SharedFolder folder;
  const std::string file = folder / "state.restart";
  double broken = 0.0;
  double formed = 0.0;
  std::map<std::int64_t, double> states;
  {
    LammpsRun run;
    run.read(structures::fullerene(1, 1));
    heat(run, 5500);
    run.commands({"fix watch all bond/topology 10", "run 600 post no", "write_restart " + file});
    broken = run.fix_vector("watch", 2);
    formed = run.fix_vector("watch", 3);
    states = run.fix_column("watch", 0);
    ASSERT_GT(broken, 0.0);
  }
  LammpsRun run;
  run.commands({"units metal", "atom_style atomic", "atom_modify map yes", "boundary f f f",
                "read_restart " + file, "pair_style rebo",
                "pair_coeff * * " + test::rebo_parameters() + " C H", "fix move all nve",
                "fix watch all bond/topology 10 file " + folder / "changes.jsonl", "run 0 post no"});
  EXPECT_EQ(run.fix_vector("watch", 2), broken);
  EXPECT_EQ(run.fix_vector("watch", 3), formed);
  EXPECT_EQ(run.fix_column("watch", 0), states);
  EXPECT_TRUE(test::lines_of(folder / "changes.jsonl").empty())
      << "nothing has changed since the restart file";
}

TEST(WatchedRun, HaltStopsTheRunAtTheFirstBrokenBond) {
  const SharedFolder folder;
  LammpsRun run;
  run.read(structures::fullerene(1, 1));
  heat(run, 5500);
  run.commands(
      {"fix watch all bond/topology 10 halt yes file " + folder / "changes.jsonl", "run 5000 post no"});
  EXPECT_LT(run.step(), 5000);
  const auto lines = lines_of_file(folder / "changes.jsonl");
  ASSERT_GE(lines.size(), 2u);
  EXPECT_EQ(lines.back()["step"], run.step());
  EXPECT_GT(lines.back()["since_start"]["broken"], 0);
  for (std::size_t k = 1; k + 1 < lines.size(); ++k) EXPECT_EQ(lines[k]["since_start"]["broken"], 0);
}

TEST(WatchedRun, MinimisationIsSeenAtItsEnd) {
  // A bond stretched beyond repair: the minimiser lets the two halves of the dimer of atoms go apart or come
  // together, and the fix says what the bonds are then.
  const SharedFolder folder;
  const Molecule ball = structures::fullerene(1, 1);
  LammpsRun run;
  run.read(ball);
  run.commands({"fix watch all bond/topology 10 file " + folder / "changes.jsonl", "run 0 post no"});
  run.place({{AtomIndex{4}, 1.35 * ball.positions[4]}});
  run.command("minimize 0 1e-4 300 1000");
  const auto lines = lines_of_file(folder / "changes.jsonl");
  ASSERT_GE(lines.size(), 1u);
  const auto places = run.positions();
  int bonds = 0;
  for (std::size_t other = 0; other < places.size(); ++other)
    bonds += other != 4 && (places[other] - places[4]).norm() < 1.7;
  EXPECT_EQ(run.fix_column("watch", 1).at(5), bonds);
}

}  // namespace
}  // namespace nanocarbon
