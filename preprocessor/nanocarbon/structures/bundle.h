// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::structures {

//! \brief Copies of a tube beside each other, hexagonally packed: those of a triangular lattice that are
//! nearest to its middle.
//! \details 7, 19 and 37 tubes make hexagons. Across, the cell of a periodic tube becomes as much wider as
//! the bundle is.
//! \param tube with its axis along z
//! \param distance of axes, Angstrom
//! \throw UserError (usage) for fewer than one tube
Molecule bundle(const Molecule& tube, int tubes, double distance);

//! \brief Copies of a tube that fill space: periodic across, too.
//! \details Rectangular cells of two tubes, `distance` along x and sqrt(3) times as much along y.
//! \throw UserError (usage) for fewer than one cell each way
Molecule bundle_crystal(const Molecule& tube, int cells_x, int cells_y, double distance);

}  // namespace nanocarbon::structures
