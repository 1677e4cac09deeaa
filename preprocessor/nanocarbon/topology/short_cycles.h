// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "nanocarbon/topology/skeleton.h"

namespace nanocarbon::topology {

//! \brief Whether a bond lies on a cycle of at most `most` bonds of the skeleton that closes in space (not
//! through a periodic boundary) and avoids the excluded half-edges.
//! \details Breadth first from both ends of the bond, so the cost does not depend on the size of the
//! molecule.
bool is_on_short_cycle(const EmbeddedGraph& graph, const Skeleton& skeleton, AtomIndex atom,
                       std::uint32_t half_edge, int most, const std::vector<std::uint8_t>& excluded);

}  // namespace nanocarbon::topology
