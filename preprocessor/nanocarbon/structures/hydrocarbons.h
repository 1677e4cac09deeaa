// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::structures {

//! Small molecules of textbook geometry in free space, with their bonds: for comparing potentials where
//! coordination numbers, hydrogen and conjugation vary. Lengths and angles are round experimental values, not
//! minima of REBO2.
Molecule methane();
Molecule methyl_radical();
Molecule acetylene();
Molecule ethynyl_radical();
Molecule ethylene();
Molecule ethane();
Molecule cyclopropane();
Molecule benzene();

}  // namespace nanocarbon::structures
