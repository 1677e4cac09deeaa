// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::structures {

//! \brief A graphene sheet in the plane z = 0, periodic along x and y.
//! \details Rectangular cells of 4 atoms, one lattice constant (2.460 Angstrom) along the zigzag direction x
//! and three bonds (4.261 Angstrom) along the armchair direction y. Along z the cell is not periodic and 20
//! Angstrom high.
//! \throw UserError (usage) where there is not at least one cell each way
Molecule graphene(int cells_x, int cells_y);

//! \brief The periodic sheet whose sides are closest to the lengths asked for (Angstrom), at least one cell
//! each way.
//! \throw UserError (usage) where a length is not positive
Molecule graphene_sheet(double length_x, double length_y);

//! \brief A flake in free space: the atoms of graphene within a radius of the middle of a ring.
//! \details Atoms left with a single bond are removed. The smallest flake is a ring of six.
//! \param radius Angstrom, at least 1.5
//! \throw UserError (usage) where the radius is less
Molecule graphene_flake(double radius);

}  // namespace nanocarbon::structures
