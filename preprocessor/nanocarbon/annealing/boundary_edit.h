// SPDX-License-Identifier: GPL-2.0-or-later
// Edits that add atoms to a network's boundary and take them away.
#pragma once

#include <optional>

#include "nanocarbon/annealing/network_edit.h"

namespace nanocarbon::annealing {

//! \brief Adds an open atom in a bond of the boundary: the ring behind it gains an atom, the chain before it
//! becomes two that meet in the new atom.
//! \return nothing where the bond does not lie between a ring and the boundary
std::optional<NetworkEdit> insert_open_atom(const TrivalentNetwork& network, AtomIndex atom, unsigned slot);

//! \brief Takes an open atom out and joins its neighbours by a bond; the opposite of insert_open_atom().
//! \return nothing where the atom is not open, or where the result would be no simple triangulation
std::optional<NetworkEdit> remove_open_atom(const TrivalentNetwork& network, AtomIndex atom);

//! \brief Closes a chain of the boundary to a ring of so many atoms by adding up to four.
//! \return nothing where the chain is too long for that or too short, or the result would be no simple
//! triangulation
std::optional<NetworkEdit> close_chain(const TrivalentNetwork& network, RingIndex chain, std::uint32_t size);

//! \brief Opens a ring by taking its open atoms away, one to four beside each other; the opposite of
//! close_chain().
//! \return nothing where the ring has none, where they do not lie beside each other, or where an atom would be
//! left with one neighbour, or a bond between two places of the boundary
std::optional<NetworkEdit> open_ring(const TrivalentNetwork& network, RingIndex ring);

}  // namespace nanocarbon::annealing
