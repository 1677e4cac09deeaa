// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::building {

//! \brief How close two carbons come that belong to different sheets, or to parts of one that face each other.
//! \details Those are more than four bonds apart; within a flat sheet such are 4.9 Angstrom apart or more.
//! \param reach how far to look, Angstrom
//! \return infinity where no two are within reach
double closest_of_facing_sheets(const Molecule& molecule, double reach);

}  // namespace nanocarbon::building
