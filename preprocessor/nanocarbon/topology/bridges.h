// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "nanocarbon/topology/skeleton.h"

namespace nanocarbon::topology {

//! \brief For each half-edge of the skeleton, whether its bond alone holds two parts together.
//! \details Depth first with the lowest atom reached (Tarjan 1974), linear. Bonds outside the skeleton count
//! as none.
std::vector<std::uint8_t> find_bridges(const EmbeddedGraph& graph, const Skeleton& skeleton);

}  // namespace nanocarbon::topology
