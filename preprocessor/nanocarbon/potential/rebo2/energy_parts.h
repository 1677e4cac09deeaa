// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace nanocarbon::rebo2 {

//! The parts of the energy of bonds, eV. b = (p_ij + p_ji)/2 + pi_RC + T S.
struct EnergyParts {
  double repulsive = 0.0;    //!< sum of w V_R
  double sigma_pi = 0.0;     //!< sum of w V_A (p_ij + p_ji)/2
  double conjugation = 0.0;  //!< sum of w V_A pi_RC
  double dihedral = 0.0;     //!< sum of w V_A T S
  double torsion = 0.0;      //!< AIREBO's E_torsion; REBO2 has none

  double bond_order() const { return repulsive + sigma_pi + conjugation + dihedral; }
  double total() const { return bond_order() + torsion; }
  EnergyParts& operator+=(const EnergyParts& other) {
    repulsive += other.repulsive;
    sigma_pi += other.sigma_pi;
    conjugation += other.conjugation;
    dihedral += other.dihedral;
    torsion += other.torsion;
    return *this;
  }
};

}  // namespace nanocarbon::rebo2
