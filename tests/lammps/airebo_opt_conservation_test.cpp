// SPDX-License-Identifier: GPL-2.0-or-later
//! \file
//! \brief Energy over 10,000 steps of molecular dynamics of molecules in contact, airebo/opt beside airebo.

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

//! Two C60 that fall on each other.
Molecule pair_of_fullerenes() {
  Molecule pair = structures::fullerene(1, 1);
  const Molecule other = pair;
  for (std::size_t i = 0; i < other.size(); ++i) {
    pair.positions.push_back(other.positions[i] + Vec3(10.0, 0.4, 0.2));
    pair.elements.push_back(other.elements[i]);
  }
  pair.bonds.clear();
  pair.rings = {};
  return pair;
}

//! The largest distance of the total energy from its start, eV, looked at every 100 steps.
double drift(const std::string& style) {
  LammpsRun run;
  run.read(pair_of_fullerenes(), style);
  run.commands({"minimize 0 1e-6 200 2000", "reset_timestep 0",
                "velocity all create 2000 7 mom yes rot yes loop geom", "timestep 0.0005", "fix 1 all nve",
                "compute kinetic all ke", "thermo 100", "thermo_style custom step pe c_kinetic", "run 0"});
  const double start = total_energy(run);
  double largest = 0.0;
  for (int part = 0; part < 100; ++part) {
    run.command("run 100");
    largest = std::max(largest, std::abs(total_energy(run) - start));
  }
  return largest;
}

TEST(AireboOpt, ConservesEnergyAsWellAsAireboOver10000Steps) {
  for (const std::string style : {"airebo", "airebo/morse"}) {
    SCOPED_TRACE(style);
    const double theirs = drift(style + " 3.0");
    const double ours = drift(style + "/opt 3.0");
    // Both fluctuate as the integrator makes them; trajectories part after some thousand steps.
    EXPECT_LT(ours, 1.5 * theirs);
    // Of a kinetic energy of 15 eV.
    EXPECT_LT(ours, 0.2);
  }
}

}  // namespace
}  // namespace nanocarbon::test
