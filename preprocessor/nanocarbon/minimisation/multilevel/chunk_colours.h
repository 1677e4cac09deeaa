// SPDX-License-Identifier: GPL-2.0-or-later
// Which parts of a graph may be worked on at once.
#pragma once

#include "nanocarbon/minimisation/multilevel/node_graph.h"

namespace nanocarbon::multilevel {

//! \brief Chunks of consecutive nodes, by colour: chunks of one colour are not coupled.
//! \details Who works through the colours in this order, and through the chunks of each in any, gets the same
//! as one who works through them one by one.
//! \param pattern nodes that each node is coupled with, in both directions
std::vector<std::vector<std::uint32_t>> chunks_by_colour(const NodeGraph& pattern,
                                                         std::uint32_t nodes_in_chunk);

}  // namespace nanocarbon::multilevel
