// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/potential/rebo2/energy_parts.h"

namespace nanocarbon::airebo {

//! The parts of the energy, eV.
struct AireboEnergyParts {
  rebo2::EnergyParts bonds;  //!< E_REBO in its parts, and E_torsion
  double long_range = 0.0;   //!< E_LJ

  double rebo() const { return bonds.bond_order(); }
  double torsion() const { return bonds.torsion; }
  double total() const { return bonds.total() + long_range; }
};

}  // namespace nanocarbon::airebo
