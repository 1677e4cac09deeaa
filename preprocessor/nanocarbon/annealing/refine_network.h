// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/annealing/switching_patch.h"

namespace nanocarbon::annealing {

//! \brief A molecule with four times the atoms and the same defects: every triangle of the triangulation is
//! cut in four.
//! \details New rings are hexagons (boundary vertices aside). Positions are doubled, so that bonds keep their
//! length, and put back on the surface, which has to be the one for the new size.
SwitchingState refined_in_four(const SwitchingState& coarse, const TetherSurface& finer_surface);

}  // namespace nanocarbon::annealing
