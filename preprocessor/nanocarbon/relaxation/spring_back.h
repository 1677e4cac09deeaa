#pragma once

#include <vector>

#include "nanocarbon/relaxation/surface_fit.h"
#include "nanocarbon/relaxation/switching_patch.h"

namespace nanocarbon {

//! What a molecule does when its tether is let go.
struct SpringBack {
  double energy = 0;            //!< eV for each atom, fixed-bond REBO2 alone
  double mean_distance = 0;     //!< of the atoms to the surface after the best motion, Angstrom
  Similarity fit;               //!< that motion
  std::vector<double> heights;  //!< above the surface after it, smoothed over neighbours, Angstrom
};

//! Lets a copy of the molecule go and measures how far it comes from the surface.
//! \param with_scale whether the molecule may be of another size than the surface
SpringBack spring_back(const SwitchingState& state, const TetherSurface& surface, bool with_scale);

//! \brief Holds a molecule from now on as far on the other side of the surface as it springs back.
//! \details Bonds switched under such a tether leave a molecule that comes to rest nearer to the surface
//! itself: what makers of sheet metal parts do with their dies (Gan and Wagoner 2004).
void compensate(SwitchingState& state, const SpringBack& spring_back);

}  // namespace nanocarbon
