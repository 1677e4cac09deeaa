// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/core/element.h"

namespace nanocarbon {

//! The distances over which a potential switches the bond of a pair of elements off, Angstrom.
struct BondCutoff {
  double begin;  //!< the bond is whole up to here
  double end;    //!< no bond from here on
};

//! One for each pair of elements.
struct BondCutoffs {
  BondCutoff carbon_carbon;
  BondCutoff carbon_hydrogen;
  BondCutoff hydrogen_hydrogen;

  constexpr const BondCutoff& of(Element a, Element b) const {
    return a != b ? carbon_hydrogen : a == Element::carbon ? carbon_carbon : hydrogen_hydrogen;
  }
};

//! Those of REBO2, AIREBO and AIREBO-M (Brenner et al. 2002, table 2; Stuart et al. 2000, table I).
inline constexpr BondCutoffs rebo_bond_cutoffs = {{1.7, 2.0}, {1.3, 1.8}, {1.1, 1.7}};

}  // namespace nanocarbon
