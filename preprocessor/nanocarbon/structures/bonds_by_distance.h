#pragma once

#include <vector>

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon {

//! \brief The bonds of a structure whose bonds are all shorter than any other distance in it.
//! \param longest a length between the longest bond and the shortest distance that is none, Angstrom
//! \return sorted and unique, each with the image of its second atom
std::vector<Bond> bonds_by_distance(const Molecule& molecule, double longest);

//! \brief Removes atoms with fewer than two bonds, again and again until there are none (what a cut leaves
//! behind). \pre the bonds are known; rings are not yet (they are left empty) \return the remaining atoms in
//! their order
Molecule without_dangling_atoms(const Molecule& molecule);

}  // namespace nanocarbon
