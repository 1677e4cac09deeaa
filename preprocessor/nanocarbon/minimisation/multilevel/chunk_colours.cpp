// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/multilevel/chunk_colours.h"

#include <algorithm>

namespace nanocarbon::multilevel {

namespace {

NodeGraph coupled_chunks(const NodeGraph& pattern, std::uint32_t nodes_in_chunk) {
  const auto chunks = static_cast<std::uint32_t>((pattern.size() + nodes_in_chunk - 1) / nodes_in_chunk);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> coupled;
  std::vector<std::uint32_t> last(chunks, static_cast<std::uint32_t>(-1));
  for (std::uint32_t i = 0; i < pattern.size(); ++i)
    for (const std::uint32_t j : pattern.of(i)) {
      const std::uint32_t own = i / nodes_in_chunk, other = j / nodes_in_chunk;
      if (other <= own || last[other] == own) continue;
      last[other] = own;
      coupled.emplace_back(own, other);
    }
  return graph_of_pairs(chunks, coupled);
}

}  // namespace

std::vector<std::vector<std::uint32_t>> chunks_by_colour(const NodeGraph& pattern,
                                                         std::uint32_t nodes_in_chunk) {
  const NodeGraph graph = coupled_chunks(pattern, nodes_in_chunk);
  std::vector<std::uint32_t> colour(graph.size(), 0);
  std::vector<std::vector<std::uint32_t>> result;
  for (std::uint32_t c = 0; c < graph.size(); ++c) {
    std::vector<bool> taken(graph.of(c).size() + 1, false);
    for (const std::uint32_t n : graph.of(c))
      if (n < c && colour[n] < taken.size()) taken[colour[n]] = true;
    colour[c] = static_cast<std::uint32_t>(std::find(taken.begin(), taken.end(), false) - taken.begin());
    if (colour[c] >= result.size()) result.resize(colour[c] + 1);
    result[colour[c]].push_back(c);
  }
  return result;
}

}  // namespace nanocarbon::multilevel
