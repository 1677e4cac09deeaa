// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/core/space.h"
#include "nanocarbon/minimisation/multilevel/coarsening.h"

namespace nanocarbon::multilevel {

//! A displacement of each node as a weighted sum of those of some coarse nodes.
struct Interpolation {
  NodeGraph coarse;             //!< coarse nodes of each node, sorted
  std::vector<double> weights;  //!< one for each of them; those of a node add up to 1
};

//! \brief Moving least squares about each node (Lancaster and Salkauskas 1981) over the ten coarse nodes next to
//! it on the sheet.
//! \details Polynomials of first degree in space, and of second degree in the two directions in which the coarse
//! nodes spread most: rigid motions and bending come out right where the sheet's radius of curvature is more
//! than the distance of coarse nodes, rigid motions in any case. Where there are too few nodes for all terms the
//! least ones are used.
//! \param positions of the fine nodes, Angstrom
Interpolation quadratic_interpolation(const Space& space, std::span<const Vec3> positions,
                                      const Coarsening& coarsening);

}  // namespace nanocarbon::multilevel
