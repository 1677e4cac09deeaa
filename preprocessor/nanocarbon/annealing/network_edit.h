// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "nanocarbon/annealing/trivalent_network.h"

namespace nanocarbon::annealing {

//! A change of the bond graph that has not been made yet: new records of the atoms concerned, and what it
//! does to ring sizes. Trials apply it to a patch, commit_edit() to the network. The last four are in
//! boundary_edit.h.
struct NetworkEdit {
  enum class Kind { flip, collapse, split, insert, remove, close, open };
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
  //! \name Filled in by the functions that make edits
  //! @{
  std::vector<AtomIndex> centre = {};  //!< those of the bond flipped or removed, those added or removed
  std::uint32_t polygon = 0;           //!< size of a ring that atoms added outside are placed around
  int added = 0, removed = 0;          //!< atoms; those added are the first of added_atoms
  int rings_added = 0;                 //!< the first of added_rings
  bool new_rings_open = false;         //!< those added are chains on the boundary
  RingIndex opened = no_atom;          //!< comes to lie on the boundary
  RingIndex closed = no_atom;          //!< no longer does
  //! @}

  int atoms_added() const { return added - removed; }
};

//! Stand for the atoms and rings that an edit adds, until commit_edit() gives them entries.
inline constexpr std::array<AtomIndex, 4> added_atoms = {0xfffffff0u, 0xfffffff1u, 0xfffffff2u, 0xfffffff3u};
inline constexpr std::array<RingIndex, 3> added_rings = {0xfffffff8u, 0xfffffff9u, 0xfffffffau};
inline bool is_added_atom(AtomIndex atom) {
  return atom >= added_atoms.front() && atom <= added_atoms.back();
}
inline bool is_added_ring(RingIndex ring) {
  return ring >= added_rings.front() && ring <= added_rings.back();
}

//! Fewest atoms of a chain between open atoms: with one, an atom would have one neighbour.
inline constexpr std::uint32_t shortest_chain = 2;

//! \brief Stone-Wales switch of the bond at a slot of an atom: an edge flip of the triangulation.
//! \details The rings at its sides lose an atom, the rings at its ends gain one; of chains on the boundary the
//! same holds. Nothing where the result would be no simple triangulation, would leave an atom with one
//! neighbour, or a bond between two places of the boundary.
std::optional<NetworkEdit> flip_bond(const TrivalentNetwork& network, AtomIndex atom, unsigned slot);

//! Removes the two atoms of a bond and merges the rings at its sides, which must not be on the boundary: an edge
//! collapse. Nothing as in flip_bond().
std::optional<NetworkEdit> collapse_bond(const TrivalentNetwork& network, AtomIndex atom, unsigned slot);

//! \brief Adds an atom in two bonds of a ring and a bond between them: a vertex split.
//! \param first position in the ring (order of atoms_of_ring) of the atom before the first bond
//! \param count atoms that go to the new ring, 1 to size - 1; the rings get size - count + 2 and count + 2
//! atoms
std::optional<NetworkEdit> split_ring(const TrivalentNetwork& network, RingIndex ring, unsigned first,
                                      unsigned count);

//! Rings that share a bond with the given one, in order; of a chain on the boundary its two neighbours there come
//! first and last.
void link_of(const TrivalentNetwork& network, RingIndex ring, std::vector<AtomIndex>& atoms,
             std::vector<RingIndex>& link);

//! Collects an edit's records, which start as those of the network.
class EditBuilder {
 public:
  EditBuilder(const TrivalentNetwork& network, NetworkEdit& edit) : network_(network), edit_(edit) {}

  TrivalentAtom& record(AtomIndex atom);
  void add(AtomIndex atom, const TrivalentAtom& record) { edit_.atoms.push_back({atom, record}); }
  void remove(AtomIndex atom);
  //! Nothing for no_atom, across a side on the boundary.
  void rebond(AtomIndex atom, AtomIndex from, AtomIndex to);
  void relabel(AtomIndex atom, RingIndex from, RingIndex to);

 private:
  const TrivalentNetwork& network_;
  NetworkEdit& edit_;
};

//! The entries that an edit's added atoms and rings were given.
struct CommittedEdit {
  std::array<AtomIndex, added_atoms.size()> atoms;
  std::array<RingIndex, added_rings.size()> rings;

  AtomIndex entry(AtomIndex atom) const { return is_added_atom(atom) ? atoms[atom - added_atoms[0]] : atom; }
  RingIndex ring_entry(RingIndex ring) const {
    return is_added_ring(ring) ? rings[ring - added_rings[0]] : ring;
  }
};

//! Makes the change.
CommittedEdit commit_edit(TrivalentNetwork& network, const NetworkEdit& edit,
                          std::vector<AtomIndex>& free_atoms, std::vector<RingIndex>& free_rings);

}  // namespace nanocarbon::annealing
