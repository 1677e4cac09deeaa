// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/multilevel/node_graph.h"

#include <algorithm>

namespace nanocarbon::multilevel {

NodeGraph bonded_atoms(std::size_t atoms, std::span<const Bond> bonds) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  pairs.reserve(bonds.size());
  for (const Bond& bond : bonds) pairs.emplace_back(bond.first, bond.second);
  return graph_of_pairs(atoms, pairs);
}

NodeGraph graph_of_pairs(std::size_t nodes, std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs) {
  NodeGraph graph;
  graph.offsets.assign(nodes + 1, 0);
  for (const auto& [a, b] : pairs) {
    if (a == b) continue;
    ++graph.offsets[a + 1];
    ++graph.offsets[b + 1];
  }
  for (std::size_t i = 0; i < nodes; ++i) graph.offsets[i + 1] += graph.offsets[i];
  std::vector<std::uint32_t> all(graph.offsets.back()), fill(graph.offsets.begin(), graph.offsets.end() - 1);
  for (const auto& [a, b] : pairs) {
    if (a == b) continue;
    all[fill[a]++] = b;
    all[fill[b]++] = a;
  }
  graph.nodes.reserve(all.size());
  for (std::size_t i = 0; i < nodes; ++i) {
    const auto begin = all.begin() + graph.offsets[i], end = all.begin() + fill[i];
    std::sort(begin, end);
    graph.offsets[i] = static_cast<std::uint32_t>(graph.nodes.size());
    graph.nodes.insert(graph.nodes.end(), begin, std::unique(begin, end));
  }
  graph.offsets[nodes] = static_cast<std::uint32_t>(graph.nodes.size());
  return graph;
}

NodeGraph renumbered(const NodeGraph& graph, std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> number(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) number[order[i]] = i;
  NodeGraph result;
  result.nodes.reserve(graph.nodes.size());
  for (const std::uint32_t former : order) {
    const auto begin = static_cast<std::ptrdiff_t>(result.nodes.size());
    for (const std::uint32_t n : graph.of(former)) result.nodes.push_back(number[n]);
    std::sort(result.nodes.begin() + begin, result.nodes.end());
    result.offsets.push_back(static_cast<std::uint32_t>(result.nodes.size()));
  }
  return result;
}

bool is_connected(const NodeGraph& graph) {
  if (graph.size() == 0) return true;
  std::vector<bool> reached(graph.size(), false);
  std::vector<std::uint32_t> next = {0};
  reached[0] = true;
  std::size_t count = 1;
  while (!next.empty()) {
    const std::uint32_t node = next.back();
    next.pop_back();
    for (const std::uint32_t n : graph.of(node)) {
      if (reached[n]) continue;
      reached[n] = true;
      ++count;
      next.push_back(n);
    }
  }
  return count == graph.size();
}

NodeGraph transposed(const NodeGraph& graph, std::size_t columns) {
  NodeGraph result;
  result.offsets.assign(columns + 1, 0);
  for (const std::uint32_t column : graph.nodes) ++result.offsets[column + 1];
  for (std::size_t c = 0; c < columns; ++c) result.offsets[c + 1] += result.offsets[c];
  result.nodes.resize(graph.nodes.size());
  std::vector<std::uint32_t> fill(result.offsets.begin(), result.offsets.end() - 1);
  for (std::uint32_t row = 0; row < graph.size(); ++row)
    for (const std::uint32_t column : graph.of(row)) result.nodes[fill[column]++] = row;
  return result;
}

}  // namespace nanocarbon::multilevel
