// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::molecule {

//! Two atoms that are too close, by indices, first below second; equal for an atom that is close to its own
//! image.
struct ClosePair {
  AtomIndex first, second;
  double distance;  //!< Angstrom, to the nearest image
};

struct CloseAtoms {
  std::vector<ClosePair> pairs;  //!< nearest first
  bool all = true;               //!< whether these are all there are
};

//! \brief Atoms closer to each other than a distance, also through the periodic boundary.
//! \details Linear in atoms: the search ends after some pairs for each atom, so that a file whose atoms are all
//! in one place is told as quickly.
//! \param distance Angstrom, above zero; no two bonded atoms of carbon or hydrogen are within 0.5 of each other
CloseAtoms find_close_atoms(const Molecule& molecule, double distance);

}  // namespace nanocarbon::molecule
