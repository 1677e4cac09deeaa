// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::structures {

struct SpringRelaxationOptions {
  double bond = 1.43;  //!< rest length of bonds, Angstrom
  double ring_stiffness =
      0.3;               //!< of springs between second neighbours in a ring, relative to those of bonds
  int iterations = 100;  //!< at most; more hardly changes bonds, also with a million atoms
};

struct SpringResult {
  int iterations;
  double shortest_bond;  //!< Angstrom
  double longest_bond;   //!< Angstrom
};

//! \brief Evens out bonds and angles of a constructed structure, as a start for a minimisation with a real
//! potential.
//! \details Springs on bonds, and between second neighbours whose rest length is that of a regular flat ring,
//! minimised by L-BFGS, in a cell that stays. Nothing is bonded or cut.
//! \pre bonds and rings are known
SpringResult relax_by_springs(Molecule& molecule, const SpringRelaxationOptions& options);

}  // namespace nanocarbon::structures
