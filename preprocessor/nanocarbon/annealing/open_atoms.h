// SPDX-License-Identifier: GPL-2.0-or-later
// Hydrogen at carbon with two carbon neighbours, without atoms of its own.
#pragma once

#include <cstddef>

namespace nanocarbon::annealing {

//! \brief REBO2 of a carbon atom with two carbon bonds and a hydrogen atom opposite to their sum, as a function
//! of the angle between the bonds.
//! \details The hydrogen lies in the plane of the two bonds, at the length that it has in benzene. Left free it gains
//! next to nothing in flat sheets and 0.04 eV at the ends of a (9, 0) tube.
struct OpenAtom {
  double angular_sum = 0;     //!< what the bond order of either carbon bond has under its root beyond 1
  double by_cosine = 0;       //!< its derivative by the cosine
  double hydrogen = 0;        //!< energy of the bond to hydrogen, eV, less rebo2::hydrogen_energy
  double hydrogen_slope = 0;  //!< its derivative by the cosine, eV
};

//! \param cosine of the angle between the two carbon bonds
OpenAtom open_atom(double cosine);

//! pi_RC of a bond between carbons of which so many, 1 or 2, are open.
double pi_of_open_bond(std::size_t open_ends);

}  // namespace nanocarbon::annealing
