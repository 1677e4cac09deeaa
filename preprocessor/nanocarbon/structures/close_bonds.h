// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::structures {

//! Bonds every pair of atoms that is close enough, carbon up to 1.7 Angstrom (topology/bond_graph.h). In the
//! structures of this room bonds are shorter than 1.6 and everything else is more than 2 Angstrom apart.
void add_bonds(Molecule& molecule);

//! Finds the rings of at most `largest` atoms that an sp2 structure's bonds make
//! (topology/surface_topology.h).
//! \pre the bonds are known
//! \throw UserError (failed) where the bonds do not form a surface
void add_rings(Molecule& molecule, int largest);

//! \brief Removes atoms with fewer than two bonds, again and again until there are none (what a cut leaves
//! behind).
//! \pre the bonds are known; rings are not yet (they are left empty)
//! \return the remaining atoms in their order
Molecule without_dangling_atoms(const Molecule& molecule);

}  // namespace nanocarbon::structures
