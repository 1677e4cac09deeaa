// SPDX-License-Identifier: GPL-2.0-or-later
// What LAMMPS's REBO2 makes of the structures: their bonds stay what they are, and their energies are the
// known ones.
#include <gmock/gmock.h>

#include <memory>

#include "nanocarbon/structures/capped_tube.h"
#include "nanocarbon/structures/diamond.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/schwarzite.h"
#include "nanocarbon/structures/tube.h"
#include "nanocarbon/topology/bond_graph.h"
#include "support/lammps_reference.h"

namespace nanocarbon::structures {
namespace {

using test::LammpsReference;

struct Relaxed {
  double energy_per_atom;       //!< eV
  std::vector<Vec3> positions;  //!< Angstrom; in the cell that LAMMPS has put at the origin
  bool same_bonds;
};

//! \param relaxed_lengths which edges of the cell are free, as fix box/relax takes them; empty for none
Relaxed relax(const Molecule& molecule, const std::string& relaxed_lengths = {}) {
  LammpsReference lammps;
  lammps.place(molecule.positions, molecule.elements, molecule.cell ? &*molecule.cell : nullptr);
  lammps.potential("rebo");
  lammps.command("neighbor 1.0 bin\nneigh_modify every 1 delay 0\nthermo_modify norm no");
  lammps.command("min_style cg\nmin_modify line quadratic dmax 0.05");
  if (!relaxed_lengths.empty()) lammps.command("fix box all box/relax " + relaxed_lengths + " vmax 0.002");
  // The box's own minimiser starts from a new reference each time.
  for (int round = 0; round < (relaxed_lengths.empty() ? 1 : 3); ++round)
    lammps.command("minimize 0 1e-7 3000 10000");

  Relaxed result;
  result.energy_per_atom = lammps.variable("pe") / static_cast<double>(molecule.size());
  result.positions = lammps.positions();
  std::optional<Cell> cell = molecule.cell;
  if (cell)
    cell = orthogonal_cell(Vec3(lammps.variable("lx"), lammps.variable("ly"), lammps.variable("lz")),
                           cell->periodic);
  const auto bonds = topology::bonds_within(result.positions, molecule.elements, cell ? &*cell : nullptr);
  result.same_bonds = topology::bonded_ids(bonds) == topology::bonded_ids(molecule.bonds);
  return result;
}

// The table of REBO2 energies at 0 K that three independent programs agree on, eV/atom.
struct Known {
  std::string name;
  Molecule molecule;
  double energy;
  std::string relaxed_lengths;
};

void expect_known(const Known& known) {
  SCOPED_TRACE(known.name);
  const Relaxed relaxed = relax(known.molecule, known.relaxed_lengths);
  EXPECT_TRUE(relaxed.same_bonds);
  EXPECT_NEAR(relaxed.energy_per_atom, known.energy, 5e-7);
}

TEST(RelaxedEnergies, Fullerenes) {
  expect_known({"C60", fullerene(1, 1), -6.8420645371, {}});
  expect_known({"C240", fullerene(2, 2), -7.2050937785, {}});
  expect_known({"C540", fullerene(3, 3), -7.2946542624, {}});
  expect_known({"C720", fullerene(6, 0), -7.3151903758, {}});
  expect_known({"C960", fullerene(4, 4), -7.3324924275, {}});
}

TEST(RelaxedEnergies, Crystals) {
  expect_known({"graphene", graphene(6, 4), -7.3949972517, "x 0.0 y 0.0"});
  expect_known({"diamond", diamond(3, 3, 3), -7.3699966410, "iso 0.0"});
  expect_known({"D688", schwarzite_d688(2, 2, 2), -7.245690, "iso 0.0"});
  expect_known({"P688", schwarzite_p688(2, 2, 2), -7.118862, "iso 0.0"});
}

TEST(RelaxedEnergies, PeriodicTubes) {
  expect_known({"(5, 5)", periodic_tube(5, 5, 6), -7.2461681759, "z 0.0"});
  expect_known({"(10, 10)", periodic_tube(10, 10, 6), -7.3558575398, "z 0.0"});
}

// Bending graphene costs 1.78 eV Angstrom^2 / R^2 for each atom.
TEST(RelaxedEnergies, OtherTubesFollowTheBendingEnergy) {
  for (const auto& [n, m, periods] : {std::tuple(9, 0, 4), {7, 3, 1}, {3, 7, 1}, {6, 6, 6}, {12, 0, 4}}) {
    SCOPED_TRACE(testing::Message() << "(" << n << ", " << m << ")");
    const double radius = tube_geometry(n, m).radius;
    const Relaxed relaxed = relax(periodic_tube(n, m, periods), "z 0.0");
    EXPECT_TRUE(relaxed.same_bonds);
    const double bending = 1.78 / (radius * radius);
    EXPECT_NEAR(relaxed.energy_per_atom, -7.3949972517 + bending, 0.05 * bending);
  }
}

TEST(RelaxedEnergies, MirrorImagesHaveTheSameEnergy) {
  EXPECT_NEAR(relax(fullerene(2, 1)).energy_per_atom, relax(fullerene(1, 2)).energy_per_atom, 1e-8);
}

// Closed ends cost what the twelve pentagons of a small fullerene cost: between C60's and the tube's own
// energy.
TEST(RelaxedEnergies, CappedTubesHold) {
  for (const auto& [n, m] : {std::pair(5, 5), {9, 0}, {10, 10}, {7, 3}, {8, 4}, {6, 5}}) {
    SCOPED_TRACE(testing::Message() << "(" << n << ", " << m << ")");
    const Molecule tube = capped_tube(n, m, 20.0);
    const Relaxed relaxed = relax(tube);
    EXPECT_TRUE(relaxed.same_bonds);
    EXPECT_GT(relaxed.energy_per_atom, -7.395);
    EXPECT_LT(relaxed.energy_per_atom, -6.95);
  }
  EXPECT_NEAR(relax(capped_tube(5, 5, 1.0)).energy_per_atom, -6.8420645371, 2e-6);  // C60 again
}

}  // namespace
}  // namespace nanocarbon::structures
