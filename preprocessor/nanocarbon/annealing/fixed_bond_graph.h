// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/annealing/trivalent_network.h"
#include "nanocarbon/core/space.h"
#include "nanocarbon/minimisation/multilevel/node_graph.h"
#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::annealing {

//! \brief The bonds of a molecule or of a patch of one: three neighbours of each atom, no_atom for a missing
//! one.
//! \details Every atom stands for half of each of its bonds. In a patch, atoms from `inner` on only lend
//! their positions: they stand for nothing, and bonds to them have no dihedral term.
struct FixedBondGraph {
  std::vector<std::array<AtomIndex, 3>> neighbours;
  std::size_t inner = static_cast<std::size_t>(-1);
  //! Whether atoms with two neighbours bind hydrogen, which has no entry (open_atoms.h).
  bool hydrogen = false;
  double steric_reach = default_steric_reach;  //!< of unbonded atoms, see steric_contacts.h; Angstrom
  Space space = {};  //!< of the positions: in a cell each bond is with the nearest image

  std::size_t inner_count() const { return std::min(inner, neighbours.size()); }
  bool complete(AtomIndex atom) const {
    const auto& n = neighbours[atom];
    return n[0] != no_atom && n[1] != no_atom && n[2] != no_atom;
  }
  //! Neighbours of an atom.
  const std::array<AtomIndex, 3>& operator()(AtomIndex atom) const { return neighbours[atom]; }
  //! Whether an atom has two neighbours, and hydrogen in place of the third.
  bool open(AtomIndex atom) const {
    const auto& n = neighbours[atom];
    return hydrogen && (n[0] == no_atom) + (n[1] == no_atom) + (n[2] == no_atom) == 1;
  }
  //! Which of an atom's three neighbours another is.
  //! \pre they are bonded
  std::uint32_t slot(AtomIndex atom, AtomIndex neighbour) const {
    const auto& n = neighbours[atom];
    return n[0] == neighbour ? 0 : n[1] == neighbour ? 1 : 2;
  }
};

//! The bond graph of a molecule.
//! \throw UserError (unsuitable) if an atom has more than three bonds.
FixedBondGraph fixed_bond_graph(const Molecule& molecule);

//! \brief The graph of some atoms of a larger one, numbered as they come; bonds to others are missing.
//! \param inner number of atoms before those that only lend their positions
//! \param number no_atom for each atom of the whole; becomes the number in the part of those that are in it
FixedBondGraph part_of(const FixedBondGraph& whole, std::span<const AtomIndex> atoms, std::size_t inner,
                       std::vector<AtomIndex>& number);

//! The same graph as preconditioners want it.
multilevel::NodeGraph bonded_atoms(const FixedBondGraph& graph);

//! The bond graph of a network; unused atoms have no neighbours.
FixedBondGraph fixed_bond_graph(const TrivalentNetwork& network, const Space& space);

}  // namespace nanocarbon::annealing
