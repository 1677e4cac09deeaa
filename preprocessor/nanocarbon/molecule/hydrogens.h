// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::molecule {

struct HydrogenOptions {
  double bond_length = 1.09;  //!< of carbon to hydrogen, Angstrom
};

//! \brief Gives every carbon atom with fewer than three bonds hydrogen in the missing sp2 directions.
//! \details To two bonds comes a third opposite to their sum; to one bond two more at 120 degrees, in the
//! plane of the other atom's bonds; an atom alone becomes a flat CH3. Where the directions leave a choice (a
//! straight chain) it depends on the bonds' directions alone. Hydrogen atoms come after all others, in the
//! order of their carbon atoms; rings stay. Atoms with three bonds or more, and hydrogen atoms, are left as
//! they are.
//! \pre the bonds are known
Molecule saturated_with_hydrogen(const Molecule& molecule, const HydrogenOptions& options = {});

std::size_t hydrogen_count(const Molecule& molecule);

//! The carbon of a molecule and the bonds within it; rings stay. Nothing changes without hydrogen.
//! \pre hydrogen comes after all carbon, as above
Molecule carbon_skeleton(const Molecule& molecule);

}  // namespace nanocarbon::molecule
