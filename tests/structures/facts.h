// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <map>

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::test {

//! What can be counted and measured on a structure without knowing how it was made.
struct Facts {
  std::map<std::size_t, std::size_t> coordination;  //!< atoms with each number of bonds
  std::map<std::size_t, std::size_t> rings;         //!< rings of each size
  long euler_characteristic = 0;                    //!< atoms - bonds + rings
  double shortest_bond = 0.0;                       //!< Angstrom
  double longest_bond = 0.0;                        //!< Angstrom
  double nearest_unbonded = 0.0;                    //!< Angstrom; up to 4
  bool bonds_sorted = false;
  bool rings_follow_bonds = false;  //!< consecutive atoms of each ring are bonded
  bool sides_agree = false;         //!< no bond is run through in the same direction by two rings
};

Facts facts(const Molecule& molecule);

}  // namespace nanocarbon::test
