// SPDX-License-Identifier: GPL-2.0-or-later
//! \file
//! \brief Molecules built in periodic cells, in LAMMPS: energy, stress and topology on any number of ranks.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "input.h"
#include "lammps/lammps_run.h"
#include "nanocarbon/building/build_molecule.h"
#include "nanocarbon/shapes/formula_surface.h"
#include "nanocarbon/shapes/periodic_shapes.h"
#include "variable.h"

namespace nanocarbon {
namespace {

using test::LammpsRun;
using testing::ElementsAre;

Molecule built(const TriangleMesh& surface, std::size_t atoms, building::PotentialChoice potential) {
  building::BuildOptions options;
  options.size = building::AtomCount{atoms};
  options.quality = Quality::draft;
  options.potential = potential;
  options.relax_cell = minimisation::CellRelaxation::none;  // so that stress is left to compare
  return building::build_molecule(surface, options).molecule;
}

TriangleMesh minimal_surface(shapes::MinimalSurface::Kind kind, bool primitive) {
  shapes::MinimalSurface surface;
  surface.kind = kind;
  surface.primitive = primitive;
  return shapes::make_minimal_surface(surface);
}

TriangleMesh tube() {
  shapes::FormulaSurface surface;
  surface.formula = "sqrt(x^2 + y^2) - 6.5";
  surface.cell = orthogonal_cell(Vec3(30, 30, 27), {false, false, true});
  surface.edge = 1;
  return shapes::make_formula_surface(surface);
}

double thermo(LammpsRun& run, const std::string& keyword) {
  std::string text = keyword;
  return run.lammps().input->variable->compute_equal(text.data());
}

// Energy, and of the stress what does not change with the orientation of the cell, which LAMMPS chooses.
void expect_the_same_in_lammps(const Molecule& molecule, building::PotentialChoice choice,
                               const std::string& pair) {
  LammpsRun run;
  run.read(molecule, pair, {"box tilt large"});
  run.commands({"thermo_style custom step pe pxx pyy pzz pxy pxz pyz vol", "run 0 post no"});
  const auto potential = building::make_potential(choice);
  const potential::Evaluation& ours =
      potential->evaluate(molecule.positions, molecule.elements, &*molecule.cell, {});
  EXPECT_NEAR(thermo(run, "pe"), ours.energy, 1e-9 * std::abs(ours.energy));
  constexpr double bar = 1.6021765e6;  // eV/Angstrom^3, as LAMMPS has it
  Mat3 virial;
  virial << thermo(run, "pxx"), thermo(run, "pxy"), thermo(run, "pxz"), thermo(run, "pxy"),
      thermo(run, "pyy"), thermo(run, "pyz"), thermo(run, "pxz"), thermo(run, "pyz"), thermo(run, "pzz");
  virial *= thermo(run, "vol") / bar;
  const double tolerance = 1e-9 * std::abs(ours.energy);
  EXPECT_GT(ours.virial.norm(), 1e-2) << "there is to be stress";
  const bool all = molecule.cell->periodic == std::array<bool, 3>{true, true, true};
  if (!all) return;  // along walls LAMMPS's pressure is that of its own box
  EXPECT_NEAR(virial.trace(), ours.virial.trace(), tolerance);
  EXPECT_NEAR(virial.norm(), ours.virial.norm(), tolerance);
}

// What the fix says of the surface, and after some steps at 600 K.
void expect_topology(const Molecule& molecule, double euler, double genus) {
  std::array<double, 4> rings = {0, 0, 0, 0};
  for (std::size_t r = 0; r < molecule.rings.size(); ++r) {
    const std::size_t size = molecule.rings[r].size();
    ++rings[size >= 5 && size <= 7 ? size - 5 : 3];
  }
  LammpsRun run;
  run.read(molecule, "rebo", {"box tilt large"});
  run.commands(
      {"velocity all create 600 4711 loop geom", "fix move all nve", "fix watch all bond/topology 10"});
  for (const int steps : {0, 100}) {
    run.command("run " + std::to_string(steps) + " post no");
    EXPECT_EQ(run.fix_scalar("watch"), 0) << "intact";
    EXPECT_EQ(run.fix_vector("watch", 4), 1);
    EXPECT_EQ(run.fix_vector("watch", 5), euler);
    EXPECT_EQ(run.fix_vector("watch", 6), genus);
    EXPECT_EQ(run.fix_vector("watch", 7), 0);
    for (int k = 0; k < 4; ++k) EXPECT_EQ(run.fix_vector("watch", 8 + k), rings[static_cast<std::size_t>(k)]);
  }
}

TEST(MoleculesInCells, HaveTheSameEnergyStressAndTopologyInLammps) {
  using Kind = shapes::MinimalSurface::Kind;
  using building::PotentialChoice;
  const Molecule p = built(minimal_surface(Kind::schwarz_p, false), 300, PotentialChoice::rebo2);
  expect_the_same_in_lammps(p, PotentialChoice::rebo2, "rebo");
  expect_the_same_in_lammps(p, PotentialChoice::rebo2, "rebo/opt");
  expect_topology(p, -4, 3);
  const Molecule g = built(minimal_surface(Kind::gyroid, true), 300, PotentialChoice::rebo2);
  expect_the_same_in_lammps(g, PotentialChoice::rebo2, "rebo");
  expect_topology(g, -4, 3);
  const Molecule t = built(tube(), 420, PotentialChoice::rebo2);
  expect_the_same_in_lammps(t, PotentialChoice::rebo2, "rebo");
  expect_topology(t, 0, 1);
}

TEST(MoleculesInCells, HaveTheSameEnergyAndStressUnderAirebo) {
  using Kind = shapes::MinimalSurface::Kind;
  using building::PotentialChoice;
  const Molecule g = built(minimal_surface(Kind::gyroid, true), 300, PotentialChoice::airebo);
  expect_the_same_in_lammps(g, PotentialChoice::airebo, "airebo 3.0");
  expect_topology(g, -4, 3);
}

}  // namespace
}  // namespace nanocarbon
