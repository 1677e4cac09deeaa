// SPDX-License-Identifier: GPL-2.0-or-later
// The neighbours of each atom in a bond graph, with the periodic image that each bond leads to.
#pragma once

#include <span>
#include <vector>

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::analysis {

//! One end of a bond: where it leads to.
struct BondRowEnd {
  AtomIndex atom;
  std::array<std::int32_t, 3> image;  //!< of that atom, in cells to add to where it is given
};

//! Both ends of all bonds, in compressed rows by atom.
struct BondRows {
  std::vector<std::uint32_t> offsets = {0};  //!< size atoms + 1
  std::vector<BondRowEnd> ends;

  std::size_t atoms() const { return offsets.size() - 1; }
  std::size_t degree(AtomIndex atom) const { return offsets[atom + 1] - offsets[atom]; }
  std::span<const BondRowEnd> of(AtomIndex atom) const {
    return {ends.data() + offsets[atom], ends.data() + offsets[atom + 1]};
  }
};

//! All bonds of a molecule.
BondRows bond_rows(const Molecule& molecule);

//! Only those between carbon atoms: hydrogen closes no ring.
BondRows carbon_bond_rows(const Molecule& molecule);

//! What leads from an atom to the end of one of its bonds, Angstrom.
Vec3 bond_vector(const Molecule& molecule, AtomIndex atom, const BondRowEnd& end);

}  // namespace nanocarbon::analysis
