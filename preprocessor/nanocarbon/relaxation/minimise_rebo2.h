#pragma once

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon {

struct Rebo2MinimisationOptions {
  double force_tolerance = 1e-4;  //!< eV/Angstrom, on the largest force on an atom
  //! Enough for 1e-6 eV/Angstrom: 10,000 atoms with modes down to 1e-4 eV/Angstrom^2 took 5,000 to 7,000.
  int max_iterations = 20000;
};

struct Rebo2MinimisationResult {
  double energy = 0;     //!< eV
  double max_force = 0;  //!< eV/Angstrom
  int iterations = 0;
  bool converged = false;
  bool intact = false;  //!< bonds below 1.7 and all other pairs of carbons above 2.0 Angstrom, as before
};

//! \brief Minimises the full REBO2 energy over all positions of a molecule in free space.
//! \details L-BFGS; the energy is the one pair_style rebo evaluates, cut-offs included, so bonds could break
//! or form: `intact` tells. Hydrogens are moved too.
Rebo2MinimisationResult minimise_rebo2(Molecule& molecule, const Rebo2MinimisationOptions& options = {});

}  // namespace nanocarbon
