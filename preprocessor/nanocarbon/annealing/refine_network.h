// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/annealing/switching_patch.h"

namespace nanocarbon::annealing {

//! \brief A molecule with four times the atoms and the same defects: every triangle of the triangulation is
//! cut in four.
//! \details New rings are hexagons (boundary vertices aside). Positions are doubled, so that bonds keep their
//! length, and put back on the surface, which has to be the one for the new size.
SwitchingState refined_in_four(const SwitchingState& coarse, const TetherSurface& finer_surface);

//! \brief A molecule with h^2 + h k + k^2 times the atoms and the same defects: the Goldberg-Coxeter subdivision of
//! its triangulation.
//! \details Else as above; (2, 0) is the same.
//! \pre the molecule has no boundary
SwitchingState refined_by(const SwitchingState& coarse, int h, int k, const TetherSurface& finer_surface);

}  // namespace nanocarbon::annealing
