#pragma once

#include "nanocarbon/relaxation/dual_relaxation.h"
#include "nanocarbon/relaxation/minimise_rebo2.h"

namespace nanocarbon {

//! \brief Dual relaxation alone: from a raw dual to a minimum of REBO2 with the bonds it has.
//! \details relax_dual(), then the fixed-bond energy without a tether, then the full potential. What
//! annealing is measured against, and what makes the dual of any sound triangulation hold. \return of the
//! last step; where it is not intact, REBO2 binds other atoms than the molecule does, and the dual cannot be
//! had with these bonds
Rebo2MinimisationResult minimise_dual(Molecule& molecule, const TetherSurface& surface,
                                      double force_tolerance = 1e-3);

}  // namespace nanocarbon
