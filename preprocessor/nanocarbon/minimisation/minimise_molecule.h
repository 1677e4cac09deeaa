// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <span>

#include "nanocarbon/minimisation/lbfgs.h"
#include "nanocarbon/molecule/molecule.h"
#include "nanocarbon/potential/potential.h"

namespace nanocarbon::minimisation {

struct MinimisationOptions {
  double force_tolerance = 1e-4;  //!< eV/Angstrom, on the largest force on an atom
  //! Enough for 1e-6 eV/Angstrom: 10,000 atoms with modes down to 1e-4 eV/Angstrom^2 took 5,000 to 7,000.
  int max_iterations = 20000;
  ThreadTeam* team = nullptr;  //!< of all but the potential; may be null
  //! Asked after each iteration; true ends the minimisation early. May be empty.
  std::function<bool(int iteration, std::span<const Vec3> positions)> stop = {};
};

struct MinimisationResult {
  double energy = 0;     //!< eV
  double max_force = 0;  //!< eV/Angstrom
  int iterations = 0;
  bool converged = false;
  bool intact = false;  //!< the potential sees the molecule's bonds whole, and no others
};

//! \brief Minimises the energy of a potential over all positions of a molecule, in a cell that stays as it is.
//! \details L-BFGS; cut-offs are part of the energy, so bonds could break or form: `intact` tells. Hydrogens
//! are moved too.
MinimisationResult minimise_molecule(Molecule& molecule, potential::Potential& potential,
                                     const MinimisationOptions& options = {});

//! The energy of a molecule as a function of its positions. Both arguments outlive the result.
EnergyFunction energy_of(const Molecule& molecule, potential::Potential& potential);

}  // namespace nanocarbon::minimisation
