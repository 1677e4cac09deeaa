// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/analysis/ring_search.h"

namespace nanocarbon::analysis {

//! \brief King's rings: for each atom and each two of its neighbours, the shortest ways around.
//! \details A ring counts where, at any of its atoms, the rest of it is a shortest path between the two neighbours
//! there that avoids the atom (S. V. King, Nature 213, 1112 (1967)). Of several shortest paths all count. Each ring
//! is found once. Diamond has two six-rings an atom, graphene half a one. Linear in atoms for a given longest ring.
//! \pre no atom is crowded (crowded_atom)
RingStatistics king_rings(const BondRows& rows, const RingSearchOptions& options = {});

}  // namespace nanocarbon::analysis
