// SPDX-License-Identifier: GPL-2.0-or-later
//! \file
//! \brief What holds layers, tubes and balls together: cells that LAMMPS relaxes under airebo, under airebo/opt,
//! and that the library relaxes by itself, are the same to six digits.

#include <gmock/gmock.h>

#include <cmath>
#include <iostream>

#include "nanocarbon/minimisation/cell_minimum.h"
#include "nanocarbon/potential/airebo/airebo.h"
#include "nanocarbon/structures/bundle.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphite.h"
#include "nanocarbon/structures/tube.h"
#include "support/lammps_reference.h"

namespace nanocarbon::test {
namespace {

struct Relaxed {
  double energy;  // eV for each atom
  Vec3 edges;     // Angstrom
};

Relaxed relax_in_lammps(LammpsReference& lammps, const std::string& style, const Molecule& m,
                        bool alike_across) {
  lammps.place(m.positions, m.elements, &*m.cell);
  lammps.potential(style);
  lammps.command("neighbor 1.0 bin\nmin_style cg\nmin_modify line quadratic dmax 0.05");
  lammps.command("thermo_style custom step pe lx ly lz");
  lammps.command(std::string("fix box all box/relax x 0.0 y 0.0 z 0.0 vmax 0.001") +
                 (alike_across ? " couple xy" : ""));
  // fix box/relax starts from a new reference cell each time.
  for (int round = 0; round < 4; ++round) lammps.command("minimize 0 1e-7 300 600");
  return {lammps.variable("pe/atoms"), {lammps.variable("lx"), lammps.variable("ly"), lammps.variable("lz")}};
}

Relaxed relax_here(Molecule m, bool alike_across) {
  airebo::Airebo airebo;
  const auto relaxation =
      alike_across ? minimisation::CellRelaxation::uniaxial : minimisation::CellRelaxation::orthogonal;
  const auto relaxed =
      minimisation::minimise_in_cell(m, airebo, relaxation, {.force_tolerance = 1e-6}).minimum;
  EXPECT_TRUE(relaxed.converged);
  return {relaxed.energy / static_cast<double>(m.size()), m.cell->vectors.diagonal()};
}

//! \param alike_across x and y by the same factor
//! \return as airebo/opt has it
Relaxed compare(const std::string& what, Molecule m, bool alike_across = false) {
  SCOPED_TRACE(what);
  // Into the cell, as LAMMPS wants them.
  for (Vec3& p : m.positions)
    for (int d = 0; d < 3; ++d) {
      const double edge = m.cell->vectors(d, d);
      p[d] -= edge * std::floor((p[d] - m.cell->origin[d]) / edge);
    }
  LammpsReference lammps(true);
  const Relaxed theirs = relax_in_lammps(lammps, "airebo 3.0", m, alike_across);
  const Relaxed opt = relax_in_lammps(lammps, "airebo/opt 3.0", m, alike_across);
  const Relaxed own = relax_here(m, alike_across);
  std::cout.precision(10);
  std::cout << what << ": " << theirs.energy << " eV/atom, " << theirs.edges.transpose() << " A; airebo/opt "
            << opt.energy << ", " << opt.edges.transpose() << "; the library " << own.energy << ", "
            << own.edges.transpose() << "\n";
  for (const Relaxed& r : {opt, own}) {
    EXPECT_NEAR(r.energy, theirs.energy, 1e-8);
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(r.edges[d] / theirs.edges[d], 1.0, 1e-6);
  }
  return opt;
}

TEST(AireboCohesion, GraphiteHasLammpssLayers) {
  const Relaxed r =
      compare("graphite AB", structures::graphite({2, 2, 2}, structures::Stacking::ab, {1.40, 3.33}, false));
  EXPECT_NEAR(r.edges.z() / 2, 3.35800, 2e-5);
  EXPECT_NEAR(r.energy - -7.4265837613, -0.05053, 1e-5);  // a sheet alone: LAMMPS's airebo
}

// Hexagonally packed: how x and y share the gap hardly costs energy, so that minimisations end anywhere.
TEST(AireboCohesion, ABundleOfTubesHasLammpssGap) {
  compare("bundle of (10, 10)", structures::bundle_crystal(structures::periodic_tube(10, 10, 1), 1, 1, 16.45),
          true);
}

TEST(AireboCohesion, TheCrystalOfC60HasLammpssLatticeConstant) {
  const Molecule ball = structures::fullerene(1, 1);
  Molecule crystal;
  constexpr double edge = 14.1;
  crystal.cell = orthogonal_cell(Vec3::Constant(edge));
  for (const Vec3& at : {Vec3(0.0, 0.0, 0.0), Vec3(0.0, 0.5, 0.5), Vec3(0.5, 0.0, 0.5), Vec3(0.5, 0.5, 0.0)})
    for (const Vec3& p : ball.positions) crystal.positions.push_back(p + edge * at);
  crystal.elements.assign(crystal.size(), Element::carbon);
  compare("crystal of C60", crystal);
}

}  // namespace
}  // namespace nanocarbon::test
