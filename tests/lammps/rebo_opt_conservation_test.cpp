// SPDX-License-Identifier: GPL-2.0-or-later
//! \file
//! \brief Energy over 20,000 steps of molecular dynamics, rebo/opt beside rebo.

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "compute.h"
#include "lammps/lammps_run.h"
#include "modify.h"
#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon::test {
namespace {

double total_energy(LammpsRun& run) {
  auto& modify = *run.lammps().modify;
  const auto scalar = [&](const char* id) {
    auto* compute = modify.compute[modify.find_compute(id)];
    return compute->compute_scalar();
  };
  return scalar("thermo_pe") + scalar("kinetic");
}

//! The largest distance of the total energy from its start, eV, looked at every 200 steps.
double drift(const std::string& style) {
  LammpsRun run;
  run.read(structures::fullerene(1, 1), style);
  run.commands({"minimize 0 1e-6 200 2000", "reset_timestep 0",
                "velocity all create 2000 7 mom yes rot yes loop geom", "timestep 0.0005", "fix 1 all nve",
                "compute kinetic all ke", "thermo 200", "thermo_style custom step pe c_kinetic", "run 0"});
  const double start = total_energy(run);
  double largest = 0.0;
  for (int part = 0; part < 100; ++part) {
    run.command("run 200");
    largest = std::max(largest, std::abs(total_energy(run) - start));
  }
  return largest;
}

TEST(ReboOpt, ConservesEnergyAsWellAsReboOver20000Steps) {
  const double rebo = drift("rebo");
  const double ours = drift("rebo/opt");
  // Both fluctuate as the integrator makes them; trajectories part after some thousand steps, so they need
  // not be equal.
  EXPECT_LT(ours, 1.5 * rebo);
  // Of a kinetic energy of 7.6 eV.
  EXPECT_LT(ours, 0.1);
}

}  // namespace
}  // namespace nanocarbon::test
