// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/core/bond_cutoffs.h"
#include "nanocarbon/core/cell.h"
#include "nanocarbon/core/element.h"
#include "nanocarbon/core/vec3.h"
#include "nanocarbon/topology/bonds.h"
#include "nanocarbon/topology/connected_components.h"

namespace nanocarbon::topology {

//! A bond forms when two atoms come closer than `form` and breaks when they part farther than `breaking`,
//! Angstrom.
struct BondWindow {
  double form;
  double breaking;
};

//! Windows for each pair of elements; the defaults are the windows over which REBO switches a bond off.
struct BondDistances {
  BondWindow carbon_carbon = window(rebo_bond_cutoffs.carbon_carbon);
  BondWindow carbon_hydrogen = window(rebo_bond_cutoffs.carbon_hydrogen);
  BondWindow hydrogen_hydrogen = window(rebo_bond_cutoffs.hydrogen_hydrogen);

  static constexpr BondWindow window(const BondCutoff& cutoff) { return {cutoff.begin, cutoff.end}; }

  const BondWindow& of(Element a, Element b) const {
    return a != b ? carbon_hydrogen : a == Element::carbon ? carbon_carbon : hydrogen_hydrogen;
  }
};

//! \brief The bonds of atoms at given places, sorted, one entry for each periodic image that is bonded.
//! \details With hysteresis: a pair closer than `form` is bonded, and one closer than `breaking` where it was
//! before. A pair's bonds are recognised by its atoms and their number, not by image, so that positions may
//! have been wrapped in between. Linear in atoms.
//! \param previous the bonds before, sorted; none to start with
//! \param cell nullptr for no periodicity; positions need not lie inside it
std::vector<Bond> bonds_within(std::span<const Vec3> positions, std::span<const Element> elements,
                               const Cell* cell, const BondDistances& distances = {},
                               std::span<const Bond> previous = {});

//! A bond by the IDs that a simulation knows its atoms by, first <= second.
struct BondedIds {
  std::int64_t first;
  std::int64_t second;
  friend auto operator<=>(const BondedIds&, const BondedIds&) = default;
};

struct BondChanges {
  std::vector<BondedIds> broken;  //!< at the start, but not now
  std::vector<BondedIds> formed;  //!< now, but not at the start
  bool none() const { return broken.empty() && formed.empty(); }
};

//! Both lists sorted; a pair bonded through several images stands in its list as often.
BondChanges compare_bonds(std::span<const BondedIds> start, std::span<const BondedIds> now);

//! The bonds as pairs of indices, sorted.
std::vector<BondedIds> bonded_ids(std::span<const Bond> bonds);

//! The current component of an atom that is no longer there.
inline constexpr std::uint32_t no_component = 0xffffffffu;

//! \brief For each atom of the start, whether it is repelled: no longer in the component that most atoms of
//! its initial component are in, or lost.
//! \details Where two components hold equally many, the one that holds the lowest of the initial component's
//! atoms counts. With atoms in the order of their IDs the result depends on nothing else. Linear.
//! \param initial component of each atom at the start
//! \param now component of each of the same atoms now, or no_component
std::vector<bool> repelled_atoms(std::span<const std::uint32_t> initial, std::span<const std::uint32_t> now);

}  // namespace nanocarbon::topology
