// SPDX-License-Identifier: GPL-2.0-or-later
// What the boundary of a sheet of carbon is made of: zigzag and armchair units.
#pragma once

#include <cstddef>
#include <vector>

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::molecule {

//! \brief The boundary loops of a molecule by the chains of carbon between neighbouring open atoms.
//! \details Open atoms are those with two carbon neighbours, where hydrogen sits or a bond dangles. Chains of
//! three atoms in a row make a zigzag edge; chains of two and of four in turn an armchair edge, whose unit is
//! a pair of them. What is left are corners and irregular places. Around a flat sheet the chains' lengths less
//! three add up to -6 for each loop outside and 6 for each hole.
struct BoundaryUnits {
  std::size_t loops = 0;
  std::size_t open_atoms = 0;       //!< as many as chains
  std::size_t dead_ends = 0;        //!< atoms with less than two carbon neighbours
  std::size_t zigzag = 0;           //!< chains of a zigzag edge
  std::size_t armchair = 0;         //!< chains of an armchair edge, two a unit
  double length = 0;                //!< along the open atoms, Angstrom
  std::vector<std::size_t> chains;  //!< how many there are of each number of atoms

  std::size_t others() const { return open_atoms - zigzag - armchair; }
};

//! \pre rings are known, and run the same way around as neighbours on an orientable surface
BoundaryUnits boundary_units(const Molecule& molecule);

}  // namespace nanocarbon::molecule
