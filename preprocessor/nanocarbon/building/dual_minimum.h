// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/annealing/dual_relaxation.h"
#include "nanocarbon/minimisation/minimise_molecule.h"

namespace nanocarbon::building {

//! \brief Dual relaxation alone: from a raw dual to a minimum of REBO2 with the bonds it has.
//! \details relax_dual(), then the fixed-bond energy without a tether, then the full potential. What
//! annealing is measured against, and what makes the dual of any sound triangulation hold.
//! \return of the last step; where it is not intact, REBO2 binds other atoms than the molecule does, and the
//! dual cannot be had with these bonds
minimisation::MinimisationResult minimise_dual(Molecule& molecule, potential::Potential& potential,
                                               const annealing::TetherSurface& surface,
                                               double force_tolerance = 1e-3);

}  // namespace nanocarbon::building
