// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/core/bond_cutoffs.h"

namespace nanocarbon::minimisation {

//! \brief The distance from which two atoms without a bond are apart, Angstrom.
//! \details Where the potential lets go of them. But hydrogens that are bonded elsewhere, as in the bays of an edge, repel
//! each other well inside their cut-off: only below 1.28 Angstrom does AIREBO draw them together, where its Lennard-Jones
//! term gives way to a bond, and REBO2 not down to 1.1.
constexpr double apart_from(const BondCutoffs& cutoffs, Element a, Element b) {
  constexpr double hydrogens = 1.3;
  return a == Element::hydrogen && b == Element::hydrogen ? hydrogens : cutoffs.of(a, b).end;
}

}  // namespace nanocarbon::minimisation
