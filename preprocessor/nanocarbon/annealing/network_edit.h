// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "nanocarbon/annealing/trivalent_network.h"

namespace nanocarbon::annealing {

//! A change of the bond graph that has not been made yet: new records of the atoms concerned, and what it
//! does to ring sizes. Trials apply it to a patch, commit_edit() to the network.
struct NetworkEdit {
  enum class Kind { flip, collapse, split };
  struct AtomChange {
    AtomIndex atom;
    TrivalentAtom record;
  };
  struct RingChange {
    RingIndex ring;
    int change;
  };
  Kind kind;
  std::vector<AtomChange> atoms;
  std::vector<RingChange> rings;
  std::array<AtomIndex, 2>
      centre;  //!< the two atoms of the bond flipped, removed (collapse) or added (split)

  int atoms_added() const { return kind == Kind::flip ? 0 : kind == Kind::split ? 2 : -2; }
};

//! Stand for the atoms and the ring that a split adds, until commit_edit() gives them entries.
inline constexpr std::array<AtomIndex, 2> added_atoms = {0xfffffff0u, 0xfffffff1u};
inline constexpr RingIndex added_ring = 0xfffffff2u;

//! \brief Stone-Wales switch of the bond at a slot of an atom: an edge flip of the triangulation.
//! \details The rings at its sides lose an atom, the rings at its ends gain one. Nothing where the result
//! would be no simple triangulation, or where the boundary is touched.
std::optional<NetworkEdit> flip_bond(const TrivalentNetwork& network, AtomIndex atom, unsigned slot);

//! Removes the two atoms of a bond and merges the rings at its sides: an edge collapse. Nothing as in
//! flip_bond().
std::optional<NetworkEdit> collapse_bond(const TrivalentNetwork& network, AtomIndex atom, unsigned slot);

//! \brief Adds an atom in two bonds of a ring and a bond between them: a vertex split.
//! \param first position in the ring (order of atoms_of_ring) of the atom before the first bond
//! \param count atoms that go to the new ring, 1 to size - 1; the rings get size - count + 2 and count + 2
//! atoms
std::optional<NetworkEdit> split_ring(const TrivalentNetwork& network, RingIndex ring, unsigned first,
                                      unsigned count);

//! Makes the change. Returns the entries of added atoms (split), or the edit's centre.
std::array<AtomIndex, 2> commit_edit(TrivalentNetwork& network, const NetworkEdit& edit,
                                     std::vector<AtomIndex>& free_atoms, std::vector<RingIndex>& free_rings);

}  // namespace nanocarbon::annealing
