// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::structures {

//! \brief A carbon onion: the icosahedral fullerenes (k, k) around each other, k = innermost, innermost + 1,
//! ...
//! \details Neighbouring shells are about 3.5 Angstrom apart; there are no bonds between them.
//! \throw UserError (usage) for an innermost index or a number of shells below 1, or too many atoms
Molecule onion(int innermost, int shells);

//! Puts a molecule in free space beside another one: atoms, bonds and rings are added after its own.
void append(Molecule& molecule, const Molecule& other);

}  // namespace nanocarbon::structures
