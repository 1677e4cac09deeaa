#pragma once

#include "nanocarbon/relaxation/start_choice.h"
#include "nanocarbon/relaxation/surface_tether.h"
#include "nanocarbon/relaxation/switching_patch.h"

namespace nanocarbon {

//! \brief Lets a copy of the molecule go and measures how far it comes from the surface.
//! \details Energy: fixed-bond REBO2 alone. Distance: after the motion that fits it best.
//! \param with_scale whether the molecule may be of another size than the surface
Released spring_back(const SwitchingState& state, const TetherSurface& surface, bool with_scale);

}  // namespace nanocarbon
