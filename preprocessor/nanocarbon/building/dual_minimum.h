// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/annealing/dual_relaxation.h"
#include "nanocarbon/minimisation/minimise_molecule.h"

namespace nanocarbon::building {

//! \brief Dual relaxation alone: from a raw dual to a minimum of the potential with the same bonds.
//! \details relax_dual(), then the fixed-bond energy without a tether, then the full potential. Annealing is measured
//! against this, and it makes the dual of most sound triangulations hold.
//! \return of the last step; if it is not intact, the potential binds other atoms than the molecule does, and there is
//! no minimum with these bonds
minimisation::MinimisationResult minimise_dual(Molecule& molecule, potential::Potential& potential,
                                               const annealing::TetherSurface& surface,
                                               double force_tolerance = 1e-3);

}  // namespace nanocarbon::building
