// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/topology/bonds.h"

namespace nanocarbon::multilevel {

//! Nodes that belong to each node, in compressed rows: neighbours in a graph, or columns of a matrix.
struct NodeGraph {
  std::vector<std::uint32_t> offsets = {0};  //!< rows + 1
  std::vector<std::uint32_t> nodes;

  std::size_t size() const { return offsets.size() - 1; }
  std::span<const std::uint32_t> of(std::size_t node) const {
    return {nodes.data() + offsets[node], nodes.data() + offsets[node + 1]};
  }
};

//! Atoms bonded to each atom, sorted.
NodeGraph bonded_atoms(std::size_t atoms, std::span<const Bond> bonds);

//! The graph of pairs of nodes, each pair given once in any direction, repeated or not; rows sorted.
NodeGraph graph_of_pairs(std::size_t nodes, std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs);

//! The same graph under other numbers.
//! \param order former number of each node
NodeGraph renumbered(const NodeGraph& graph, std::span<const std::uint32_t> order);

//! Whether every node can be reached from every other.
bool is_connected(const NodeGraph& graph);

//! The columns' rows: where each node stands in the rows of a graph.
//! \param columns one more than the largest node
NodeGraph transposed(const NodeGraph& graph, std::size_t columns);

}  // namespace nanocarbon::multilevel
