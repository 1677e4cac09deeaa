// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/minimisation/multilevel/node_graph.h"

namespace nanocarbon::multilevel {

//! Some nodes of a graph that stand for all of them.
struct Coarsening {
  std::vector<std::uint32_t> chosen;  //!< the node that each coarse node is, ascending
  std::vector<std::uint32_t> owner;   //!< of each node the nearest coarse one, by steps
  NodeGraph graph;                    //!< of coarse nodes: those whose nodes touch are neighbours
};

//! \brief Chooses nodes so that no two are fewer steps than the separation apart, and no more fit in.
//! \details In an order that is the same for the same size: each component keeps at least one node.
Coarsening coarsen(const NodeGraph& graph, unsigned separation);

//! \brief An order in which nodes that follow each other are near each other, at every length: former numbers.
//! \details Coarsens again and again, and sorts each level by the owners of the one above.
std::vector<std::uint32_t> compact_order(const NodeGraph& graph);

}  // namespace nanocarbon::multilevel
