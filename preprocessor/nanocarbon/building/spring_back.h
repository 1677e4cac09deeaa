// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/annealing/surface_tether.h"
#include "nanocarbon/annealing/switching_patch.h"
#include "nanocarbon/building/start_choice.h"

namespace nanocarbon::building {

//! \brief Lets a copy of the molecule go and measures how far it comes from the surface.
//! \details Energy: fixed-bond REBO2 alone. Distance: after the motion that fits it best.
//! \param with_scale whether the molecule may be of another size than the surface
Released spring_back(const annealing::SwitchingState& state, const annealing::TetherSurface& surface,
                     bool with_scale);

}  // namespace nanocarbon::building
