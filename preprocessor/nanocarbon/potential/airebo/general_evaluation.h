// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "nanocarbon/potential/airebo/bond_paths.h"
#include "nanocarbon/potential/airebo/energy_parts.h"
#include "nanocarbon/potential/airebo/hypothetical_bond.h"
#include "nanocarbon/potential/airebo/model.h"
#include "nanocarbon/potential/rebo2/general_evaluation.h"

namespace nanocarbon::airebo {

//! Memory that the general evaluation keeps from call to call.
struct AireboWorkspace {
  rebo2::GeneralWorkspace rebo;
  BondPaths paths;
  HypotheticalBondScratch hypothetical;
};

//! \brief AIREBO of any carbon and hydrogen atoms, straight from the formulas: the reference for everything
//! faster.
//! \param atoms with copies as far as bond_reach() and as E_LJ reaches
//! \param near rows of own atoms and of copies that are two bonds or more within bond_reach()
//! \param pairs each pair within reach of E_LJ once, perhaps more, in the row of an own atom
//! \param forces x, y, z of every atom, copies included; added to, eV/Angstrom
//! \param shares where energies and virials of single atoms are added, if wanted: shared as in LAMMPS, a quarter of
//! a dihedral's energy to each atom, a path's virial to all atoms on it
AireboEnergyParts evaluate_general(const potential::AtomsView& atoms, const potential::NearPairs& near,
                                   const potential::NearPairs& pairs, const AireboModel& model,
                                   AireboWorkspace& workspace, double* forces,
                                   const potential::AtomShares& shares);

}  // namespace nanocarbon::airebo
