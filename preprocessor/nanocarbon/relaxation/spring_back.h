#pragma once

#include "nanocarbon/relaxation/surface_fit.h"
#include "nanocarbon/relaxation/switching_patch.h"

namespace nanocarbon {

//! What a molecule does when its tether is let go.
struct SpringBack {
  double energy = 0;         //!< eV for each atom, fixed-bond REBO2 alone
  double mean_distance = 0;  //!< of the atoms to the surface after the best motion, Angstrom
  Similarity fit;            //!< that motion
};

//! Lets a copy of the molecule go and measures how far it comes from the surface.
//! \param with_scale whether the molecule may be of another size than the surface
SpringBack spring_back(const SwitchingState& state, const TetherSurface& surface, bool with_scale);

}  // namespace nanocarbon
