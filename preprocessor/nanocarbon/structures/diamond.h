// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::structures {

//! Lattice constant of diamond under REBO2 at 0 K, Angstrom.
inline constexpr double diamond_lattice_constant = 3.56572;

//! \brief Diamond, periodic: cubic cells of 8 atoms, a number of them along each edge. It has no rings in our
//! sense.
//! \throw UserError (usage) where there is not at least one cell each way
Molecule diamond(int cells_x, int cells_y, int cells_z);

}  // namespace nanocarbon::structures
