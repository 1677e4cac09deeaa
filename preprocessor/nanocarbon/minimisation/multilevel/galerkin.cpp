// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/multilevel/galerkin.h"

#include <algorithm>

#include "nanocarbon/core/chunks.h"

namespace nanocarbon::multilevel {

namespace {

constexpr std::uint32_t rows_in_chunk = 2048;
constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

}  // namespace

struct GalerkinProduct::Scratch {
  explicit Scratch(std::size_t coarse_nodes) : place(coarse_nodes, none) {}
  std::vector<std::uint32_t> place;    // of a coarse node in the row of A P at hand; none where it is not
  std::vector<std::uint32_t> columns;  // of that row
  std::vector<Block> sums;             // of that row
  std::vector<Block> fine;             // of the row of A
};

GalerkinProduct::GalerkinProduct(const NodeGraph& pattern, const Interpolation& interpolation,
                                 std::size_t coarse_nodes, ThreadTeam* team)
    : team_(team) {
  const NodeGraph fine_of = transposed(interpolation.coarse, coarse_nodes);
  std::vector<std::uint32_t> seen(coarse_nodes, none), seen_fine(pattern.size(), none), row;
  for (std::uint32_t c = 0; c < coarse_nodes; ++c) {
    row.clear();
    for (const std::uint32_t i : fine_of.of(c))
      for (const std::uint32_t j : pattern.of(i)) {
        if (seen_fine[j] == c) continue;
        seen_fine[j] = c;
        for (const std::uint32_t other : interpolation.coarse.of(j))
          if (seen[other] != c) {
            seen[other] = c;
            row.push_back(other);
          }
      }
    std::sort(row.begin(), row.end());
    pattern_.nodes.insert(pattern_.nodes.end(), row.begin(), row.end());
    pattern_.offsets.push_back(static_cast<std::uint32_t>(pattern_.nodes.size()));
  }
  for (std::uint32_t begin = 0; begin < coarse_nodes; begin += rows_in_chunk) {
    Chunk chunk{begin, std::min(begin + rows_in_chunk, static_cast<std::uint32_t>(coarse_nodes)), {}};
    for (std::uint32_t c = chunk.begin; c < chunk.end; ++c)
      chunk.rows.insert(chunk.rows.end(), fine_of.of(c).begin(), fine_of.of(c).end());
    std::sort(chunk.rows.begin(), chunk.rows.end());
    chunk.rows.erase(std::unique(chunk.rows.begin(), chunk.rows.end()), chunk.rows.end());
    chunk.rows.shrink_to_fit();
    chunks_.push_back(std::move(chunk));
  }
}

// The upper half: symmetry gives the other.
void GalerkinProduct::compute_chunk(const Chunk& chunk, const NodeGraph& pattern, const RowOf& row_of,
                                    const Interpolation& interpolation, std::vector<Block>& product,
                                    Scratch& s) const {
  const NodeGraph& coarse = interpolation.coarse;
  for (const std::uint32_t i : chunk.rows) {
    row_of(i, s.fine);
    const auto columns = pattern.of(i);
    for (std::size_t k = 0; k < columns.size(); ++k)
      for (std::uint32_t e = coarse.offsets[columns[k]]; e < coarse.offsets[columns[k] + 1]; ++e) {
        const std::uint32_t other = coarse.nodes[e];
        if (s.place[other] == none) {
          s.place[other] = static_cast<std::uint32_t>(s.columns.size());
          s.columns.push_back(other);
          s.sums.push_back(Block{});
        }
        add(s.sums[s.place[other]], interpolation.weights[e], s.fine[k]);
      }
    for (std::uint32_t e = coarse.offsets[i]; e < coarse.offsets[i + 1]; ++e) {
      const std::uint32_t c = coarse.nodes[e];
      if (c < chunk.begin || c >= chunk.end) continue;
      for (std::uint32_t k = pattern_.offsets[c + 1]; k-- > pattern_.offsets[c];) {
        if (pattern_.nodes[k] < c) break;
        if (s.place[pattern_.nodes[k]] != none)
          add(product[k], interpolation.weights[e], s.sums[s.place[pattern_.nodes[k]]]);
      }
    }
    for (const std::uint32_t c : s.columns) s.place[c] = none;
    s.columns.clear();
    s.sums.clear();
  }
}

std::vector<Block> GalerkinProduct::blocks(const NodeGraph& pattern, const RowOf& row_of,
                                           const Interpolation& interpolation) const {
  std::vector<Block> product(pattern_.nodes.size(), Block{});
  for_each_index(team_, chunks_.size(), [&](std::size_t chunk) {
    Scratch scratch(pattern_.size());
    compute_chunk(chunks_[chunk], pattern, row_of, interpolation, product, scratch);
  });
  std::vector<std::uint32_t> below(pattern_.offsets.begin(), pattern_.offsets.end() - 1);
  for (std::uint32_t c = 0; c < pattern_.size(); ++c)
    for (std::uint32_t k = pattern_.offsets[c]; k < pattern_.offsets[c + 1]; ++k)
      if (pattern_.nodes[k] > c) product[below[pattern_.nodes[k]]++] = product[k];
  return product;
}

}  // namespace nanocarbon::multilevel
