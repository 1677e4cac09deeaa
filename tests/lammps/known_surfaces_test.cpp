// SPDX-License-Identifier: GPL-2.0-or-later
//! \file
//! \brief fix bond/topology on molecules whose topology is known, as they are and after a change made by
//! hand.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lammps/lammps_run.h"
#include "lammps/test_molecules.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/tube.h"

namespace nanocarbon {
namespace {

using test::LammpsRun;
using testing::ElementsAre;

constexpr double intact = 0, homeomorphic = 1, broken = 2, no_surface = 3;

// The fix's global vector: changes since the start, then the surface.
std::vector<double> changes(LammpsRun& run) {
  return {run.fix_scalar("watch"), run.fix_vector("watch", 1), run.fix_vector("watch", 2),
          run.fix_vector("watch", 3)};
}
std::vector<double> surface(LammpsRun& run) {
  std::vector<double> result;
  for (int k = 4; k <= 7; ++k) result.push_back(run.fix_vector("watch", k));
  return result;  // components, Euler characteristic, genus, boundary loops
}
std::vector<double> rings(LammpsRun& run) {
  std::vector<double> result;
  for (int k = 8; k <= 11; ++k) result.push_back(run.fix_vector("watch", k));
  return result;  // of 5, 6, 7 atoms, and others
}
bool orientable(LammpsRun& run) { return run.fix_vector("watch", 12) == 1.0; }

void watch(LammpsRun& run, const Molecule& molecule, const std::string& keywords = "") {
  run.read(molecule, "rebo");
  run.commands({"fix move all nve", "fix watch all bond/topology 1 " + keywords, "run 0 post no"});
  EXPECT_THAT(changes(run), ElementsAre(intact, 0, 0, 0));
}

void expect_still_intact_after_some_steps(LammpsRun& run) {
  const auto before = surface(run);
  run.command("run 5 post no");
  EXPECT_THAT(changes(run), ElementsAre(intact, 0, 0, 0));
  EXPECT_EQ(surface(run), before);
}

std::vector<std::int64_t> atoms_in_state(LammpsRun& run, int state) {
  std::vector<std::int64_t> ids;
  for (const auto& [id, value] : run.fix_column("watch", 0))
    if (value == state) ids.push_back(id);
  return ids;
}

// The other atom of a bond that is listed at this one.
AtomIndex partner(const Molecule& molecule, AtomIndex atom) {
  for (const Bond& bond : molecule.bonds)
    if (bond.first == atom) return bond.second;
  ADD_FAILURE() << "no bond from atom " << atom;
  return 0;
}

TEST(KnownSurfaces, C60IsASphere) {
  LammpsRun run;
  watch(run, structures::fullerene(1, 1));
  EXPECT_THAT(surface(run), ElementsAre(1, 2, 0, 0));
  EXPECT_THAT(rings(run), ElementsAre(12, 20, 0, 0));
  for (const auto& [id, coordination] : run.fix_column("watch", 1)) EXPECT_EQ(coordination, 3) << id;
  for (const auto& [id, smallest] : run.fix_column("watch", 2)) EXPECT_EQ(smallest, 5) << id;
  expect_still_intact_after_some_steps(run);
}

TEST(KnownSurfaces, C540IsASphere) {
  LammpsRun run;
  watch(run, structures::fullerene(3, 3));
  EXPECT_THAT(surface(run), ElementsAre(1, 2, 0, 0));
  EXPECT_THAT(rings(run), ElementsAre(12, 260, 0, 0));  // V - E + F = 2 with E = 3/2 V
  expect_still_intact_after_some_steps(run);
}

TEST(KnownSurfaces, OpenTubeIsAnAnnulus) {
  LammpsRun run;
  watch(run, structures::open_tube(10, 10, 20.0));
  EXPECT_THAT(surface(run), ElementsAre(1, 0, 0, 2));
  EXPECT_EQ(rings(run)[0], 0);
  EXPECT_EQ(rings(run)[2], 0);
  EXPECT_TRUE(orientable(run));
  expect_still_intact_after_some_steps(run);
}

TEST(KnownSurfaces, PeriodicTubeIsATorus) {
  LammpsRun run;
  watch(run, structures::periodic_tube(10, 10, 4));
  EXPECT_THAT(surface(run), ElementsAre(1, 0, 1, 0));
  EXPECT_THAT(rings(run), ElementsAre(0, 80, 0, 0));  // 160 atoms, half as many faces
  expect_still_intact_after_some_steps(run);
}

TEST(KnownSurfaces, PeriodicTubeOfOneCellIsATorus) {
  LammpsRun run;
  watch(run, structures::periodic_tube(
                 10, 10, 1));  // a cell of 2.46 Angstrom: atoms bonded to several images of one atom
  EXPECT_THAT(surface(run), ElementsAre(1, 0, 1, 0));
  EXPECT_THAT(rings(run), ElementsAre(0, 20, 0, 0));
  expect_still_intact_after_some_steps(run);
}

TEST(KnownSurfaces, PeriodicGrapheneIsATorus) {
  LammpsRun run;
  watch(run, structures::graphene(8, 5));
  EXPECT_THAT(surface(run), ElementsAre(1, 0, 1, 0));
  EXPECT_THAT(rings(run), ElementsAre(0, 80, 0, 0));
  expect_still_intact_after_some_steps(run);
}

TEST(KnownSurfaces, TorusMoleculeHasGenusOne) {
  LammpsRun run;
  watch(run, test::torus_molecule(4, 60));
  EXPECT_THAT(surface(run), ElementsAre(1, 0, 1, 0));
  EXPECT_THAT(rings(run), ElementsAre(0, 480, 0, 0));
  expect_still_intact_after_some_steps(run);
}

TEST(KnownSurfaces, DoubledFlakeWithTwoHolesHasGenusTwo) {
  LammpsRun run;
  watch(run, test::doubled(test::flake_with_two_holes()));
  EXPECT_THAT(surface(run), ElementsAre(1, -2, 2, 0));
  EXPECT_TRUE(orientable(run));
}

TEST(KnownSurfaces, FlakeWithTwoHolesHasThreeBoundaryLoops) {
  LammpsRun run;
  watch(run, test::flake_with_two_holes());
  EXPECT_THAT(surface(run), ElementsAre(1, -1, 0, 3));
}

TEST(KnownSurfaces, MoebiusBandIsNotOrientable) {
  LammpsRun run;
  watch(run, test::moebius_band(4, 102));
  EXPECT_THAT(surface(run), ElementsAre(1, 0, 1, 1));  // one cross-cap, one edge
  EXPECT_FALSE(orientable(run));
  expect_still_intact_after_some_steps(run);
}

TEST(ChangedSurfaces, StoneWalesRotationInGrapheneIsHomeomorphic) {
  const Molecule sheet = structures::graphene(8, 5);
  LammpsRun run;
  watch(run, sheet);
  const AtomIndex first = 70;
  const AtomIndex second = partner(sheet, first);
  const auto places = test::turned(sheet.positions[first], sheet.positions[second], Vec3::UnitZ());
  run.place({{first, places[0]}, {second, places[1]}});
  run.command("run 0 post no");
  EXPECT_THAT(changes(run), ElementsAre(homeomorphic, 0, 2, 2));
  EXPECT_THAT(surface(run), ElementsAre(1, 0, 1, 0));
  EXPECT_THAT(rings(run), ElementsAre(2, 76, 2, 0));
  EXPECT_EQ(atoms_in_state(run, 1).size(), 4u);  // each turned atom let go of one and took one
}

TEST(ChangedSurfaces, StoneWalesRotationInAFullereneIsHomeomorphic) {
  const Molecule ball = structures::fullerene(3, 3);
  LammpsRun run;
  watch(run, ball);
  // A bond whose atoms are in hexagons only, and so are its ends' rings.
  const auto smallest = run.fix_column("watch", 2);
  AtomIndex first = 0;
  AtomIndex second = 0;
  for (const Bond& bond : ball.bonds)
    if (smallest.at(bond.first + 1) == 6 && smallest.at(bond.second + 1) == 6) {
      first = bond.first;
      second = bond.second;
      break;
    }
  const Vec3 outwards = ball.positions[first] + ball.positions[second];
  const auto places = test::turned(ball.positions[first], ball.positions[second], outwards);
  run.place({{first, places[0]}, {second, places[1]}});
  run.command("run 0 post no");
  EXPECT_THAT(changes(run), ElementsAre(homeomorphic, 0, 2, 2));
  EXPECT_THAT(surface(run), ElementsAre(1, 2, 0, 0));
}

TEST(ChangedSurfaces, PulledOffAtomIsRepelled) {
  const Molecule ball = structures::fullerene(1, 1);
  LammpsRun run;
  watch(run, ball);
  run.place({{AtomIndex{16}, 2.5 * ball.positions[16]}});
  run.command("run 0 post no");
  EXPECT_THAT(changes(run), ElementsAre(broken, 1, 3, 0));
  EXPECT_EQ(run.fix_vector("watch", 4), 2);
  EXPECT_THAT(atoms_in_state(run, 2), ElementsAre(17));
  EXPECT_EQ(atoms_in_state(run, 1).size(), 3u);
  EXPECT_EQ(run.fix_column("watch", 1).at(17), 0);
}

TEST(ChangedSurfaces, PulledOffAtomThatComesBackLeavesTheMoleculeIntact) {
  const Molecule ball = structures::fullerene(1, 1);
  LammpsRun run;
  watch(run, ball);
  run.place({{AtomIndex{16}, 2.5 * ball.positions[16]}});
  run.command("run 0 post no");
  run.place({{AtomIndex{16}, ball.positions[16]}});
  run.command("run 0 post no");
  EXPECT_THAT(changes(run), ElementsAre(intact, 0, 0, 0));
  EXPECT_TRUE(atoms_in_state(run, 2).empty());
}

TEST(ChangedSurfaces, CutTubeIsTwoPieces) {
  const Molecule tube = structures::open_tube(10, 10, 20.0);
  LammpsRun run;
  watch(run, tube);
  double middle = 0.0;
  for (const Vec3& place : tube.positions) middle += place[2] / static_cast<double>(tube.size());
  const double cut = middle + 4.0;
  std::size_t above = 0;
  for (const Vec3& place : tube.positions) above += place[2] > cut;
  run.commands({"variable above atom z>" + std::to_string(run.positions()[0][2] + cut - tube.positions[0][2]),
                "group above variable above", "displace_atoms above move 0 0 3.5 units box",
                "run 0 post no"});
  EXPECT_EQ(run.fix_scalar("watch"), broken);
  EXPECT_EQ(run.fix_vector("watch", 1), static_cast<double>(above));  // the shorter part
  EXPECT_EQ(run.fix_vector("watch", 2), 20);  // a (10,10) tube's bonds along its axis through a cut of 2 x 10
  EXPECT_THAT(surface(run), ElementsAre(2, 0, 0, 4));
}

TEST(ChangedSurfaces, TwoShellsThatBondFaceToFaceAreNoSurface) {
  const Molecule ball = structures::fullerene(1, 1);
  LammpsRun run;
  watch(run, test::together(ball, ball, Vec3(0, 0, 11.0)));
  EXPECT_THAT(surface(run), ElementsAre(2, 4, 0, 0));
  // Brings the second so near that the highest atoms of the first and the lowest of the second bond.
  double top = 0.0;
  for (const Vec3& place : ball.positions) top = std::max(top, place[2]);
  double bottom = 0.0;
  for (const Vec3& place : ball.positions) bottom = std::min(bottom, place[2]);
  const double gap = 11.0 + bottom - top;
  run.commands({"group second id 61:120",
                "displace_atoms second move 0 0 " + std::to_string(-(gap - 1.5)) + " units box",
                "run 0 post no"});
  EXPECT_EQ(run.fix_scalar("watch"), no_surface);
  EXPECT_EQ(run.fix_vector("watch", 4), 1);
  EXPECT_EQ(run.fix_vector("watch", 1), 0);
  EXPECT_EQ(run.fix_vector("watch", 2), 0);
  EXPECT_GT(run.fix_vector("watch", 3), 0);
  EXPECT_TRUE(std::isnan(run.fix_vector("watch", 5)));
}

TEST(ChangedSurfaces, TwoTubesFusedEndToEndAreOneTube) {
  // One tube cut in two is brought together again: the start is the two halves.
  const Molecule tube = structures::open_tube(10, 10, 20.0);
  Molecule apart = tube;
  double middle = 0.0;
  for (const Vec3& place : tube.positions) middle += place[2] / static_cast<double>(tube.size());
  std::string upper;
  for (AtomIndex a = 0; a < apart.size(); ++a)
    if (apart.positions[a][2] > middle) {
      apart.positions[a][2] += 5.0;
      upper.append(" ").append(std::to_string(a + 1));
    }
  test::bond_by_distance(apart);
  LammpsRun run;
  watch(run, apart);
  EXPECT_THAT(surface(run), ElementsAre(2, 0, 0, 4));
  run.commands({"group upper id" + upper, "displace_atoms upper move 0 0 -5 units box", "run 0 post no"});
  EXPECT_THAT(changes(run), ElementsAre(broken, 0, 0, 20));
  EXPECT_THAT(surface(run), ElementsAre(1, 0, 0, 2));
}

TEST(ChangedSurfaces, VacancyIsALostAtom) {
  LammpsRun run;
  watch(run, structures::graphene(8, 5));
  // Default compress yes: LAMMPS gives the remaining atoms new IDs. The file and the states go by those of
  // the start.
  run.commands({"group gone id 33", "delete_atoms group gone", "run 0 post no"});
  EXPECT_THAT(changes(run), ElementsAre(broken, 1, 3, 0));
  EXPECT_THAT(rings(run), ElementsAre(0, 77, 0, 1));  // three hexagons became a ring of 12
  EXPECT_THAT(surface(run), ElementsAre(1, 0, 1, 0));
  EXPECT_EQ(atoms_in_state(run, 1).size(), 3u);
}

TEST(ChangedSurfaces, VacancyIsAHoleWhenRingsMustBeShorter) {
  LammpsRun run;
  watch(run, structures::graphene(8, 5), "maxring 11");
  run.commands({"group gone id 33", "delete_atoms group gone compress no", "run 0 post no"});
  EXPECT_THAT(changes(run), ElementsAre(broken, 1, 3, 0));
  EXPECT_THAT(surface(run), ElementsAre(1, -1, 1, 1));
}

TEST(ChangedSurfaces, CrosslinkOfTwoSheetsIsNoSurface) {
  const Molecule flake = structures::graphene_flake(7.0);
  const auto size = static_cast<AtomIndex>(flake.size());
  const Molecule two = test::together(flake, flake, Vec3(0, 0, 3.35));
  LammpsRun run;
  watch(run, two);
  EXPECT_EQ(surface(run)[0], 2);
  AtomIndex innermost = 0;
  for (AtomIndex a = 1; a < size; ++a)
    if (flake.positions[a].head<2>().norm() < flake.positions[innermost].head<2>().norm()) innermost = a;
  run.place({{innermost, two.positions[innermost] + Vec3(0, 0, 0.9)},
             {innermost + size, two.positions[innermost + size] - Vec3(0, 0, 0.9)}});
  run.command("run 0 post no");
  EXPECT_THAT(changes(run), ElementsAre(no_surface, 0, 0, 1));
  EXPECT_THAT(atoms_in_state(run, 1), ElementsAre(innermost + 1, innermost + size + 1));
  EXPECT_EQ(run.fix_column("watch", 1).at(innermost + 1), 4);
}

}  // namespace
}  // namespace nanocarbon
