// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::building {

//! \brief The smallest distance between carbons of different sheets, or of parts of one sheet that face each other.
//! \details These are more than four bonds apart; within a flat sheet such atoms are at least 4.9 Angstrom apart.
//! \param reach how far to look, Angstrom
//! \return infinity where no two are within reach
double closest_of_facing_sheets(const Molecule& molecule, double reach);

}  // namespace nanocarbon::building
