// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/multilevel/smoother.h"

#include <algorithm>

#include "nanocarbon/core/chunks.h"
#include "nanocarbon/minimisation/multilevel/chunk_colours.h"

namespace nanocarbon::multilevel {

namespace {

constexpr std::uint32_t nodes_in_chunk = 1024;

using FloatBlock = SymmetricBlock<float>;

FloatBlock to_float(const Block& block) {
  FloatBlock result;
  for (std::size_t k = 0; k < 6; ++k) result[k] = static_cast<float>(block[k]);
  return result;
}

struct Sum {
  float x, y, z;
};

inline void subtract_product(Sum& sum, const FloatBlock& b, const float* v) {
  sum.x -= b[0] * v[0] + b[1] * v[1] + b[2] * v[2];
  sum.y -= b[1] * v[0] + b[3] * v[1] + b[4] * v[2];
  sum.z -= b[2] * v[0] + b[4] * v[1] + b[5] * v[2];
}

inline void store_product(float* out, const FloatBlock& b, const Sum& v) {
  out[0] = b[0] * v.x + b[1] * v.y + b[2] * v.z;
  out[1] = b[1] * v.x + b[3] * v.y + b[4] * v.z;
  out[2] = b[2] * v.x + b[4] * v.y + b[5] * v.z;
}

}  // namespace

Smoother::Smoother(const NodeGraph& pattern, ThreadTeam* team)
    : colours_(chunks_by_colour(pattern, nodes_in_chunk)), team_(team) {
  std::vector<std::uint32_t> colour((pattern.size() + nodes_in_chunk - 1) / nodes_in_chunk);
  for (std::uint32_t c = 0; c < colours_.size(); ++c)
    for (const std::uint32_t chunk : colours_[c]) colour[chunk] = c;
  const auto before = [&](std::uint32_t i, std::uint32_t j) {
    const std::uint32_t a = colour[i / nodes_in_chunk], b = colour[j / nodes_in_chunk];
    return a != b ? a < b : i < j;
  };
  rows_.reserve(pattern.size());
  nodes_.reserve(pattern.nodes.size() - pattern.size());
  place_.reserve(pattern.nodes.size() - pattern.size());
  for (std::uint32_t i = 0; i < pattern.size(); ++i) {
    const auto row = pattern.of(i);
    const auto list = [&](bool first) {
      for (std::uint32_t k = 0; k < row.size(); ++k)
        if (row[k] != i && before(row[k], i) == first) {
          nodes_.push_back(row[k]);
          place_.push_back(k);
        }
      return static_cast<std::uint32_t>(nodes_.size());
    };
    const auto begin = static_cast<std::uint32_t>(nodes_.size());
    const std::uint32_t middle = list(true);
    rows_.push_back({begin, middle, list(false)});
  }
}

std::uint32_t Smoother::begin_of(std::uint32_t chunk) const { return chunk * nodes_in_chunk; }

std::uint32_t Smoother::end_of(std::uint32_t chunk) const {
  return std::min(static_cast<std::uint32_t>(rows_.size()), (chunk + 1) * nodes_in_chunk);
}

void Smoother::set(const NodeGraph& pattern, const RowOf& row_of) {
  blocks_.resize(nodes_.size());
  inverse_.resize(rows_.size());
  for_chunks(team_, rows_.size(), [&](std::size_t begin, std::size_t end) {
    std::vector<Block> row;
    for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
      row_of(i, row);
      const auto columns = pattern.of(i);
      const auto own = std::lower_bound(columns.begin(), columns.end(), i) - columns.begin();
      inverse_[i] = to_float(inverse(row[static_cast<std::size_t>(own)]));
      for (std::uint32_t e = rows_[i].begin; e < rows_[i].end; ++e) blocks_[e] = to_float(row[place_[e]]);
    }
  });
}

void Smoother::sweep_from_zero(const Displacements& b, Displacements& x, Displacements& residual) const {
  for (const std::vector<std::uint32_t>& colour : colours_)
    for_each_index(team_, colour.size(), [&](std::size_t k) {
      for (std::uint32_t i = begin_of(colour[k]); i < end_of(colour[k]); ++i) {
        Sum sum = {b[3 * i], b[3 * i + 1], b[3 * i + 2]};
        for (std::uint32_t e = rows_[i].begin; e < rows_[i].middle; ++e)
          subtract_product(sum, blocks_[e], &x[3 * nodes_[e]]);
        store_product(&x[3 * i], inverse_[i], sum);
      }
    });
  // What was swept before a node has been met by its own sweep.
  for_chunks(team_, rows_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Sum sum = {0, 0, 0};
      for (std::uint32_t e = rows_[i].middle; e < rows_[i].end; ++e)
        subtract_product(sum, blocks_[e], &x[3 * nodes_[e]]);
      residual[3 * i] = sum.x;
      residual[3 * i + 1] = sum.y;
      residual[3 * i + 2] = sum.z;
    }
  });
}

void Smoother::sweep_back(const Displacements& b, Displacements& x) const {
  for (std::size_t c = colours_.size(); c-- > 0;)
    for_each_index(team_, colours_[c].size(), [&](std::size_t k) {
      const std::uint32_t chunk = colours_[c][k];
      for (std::uint32_t i = end_of(chunk); i-- > begin_of(chunk);) {
        Sum sum = {b[3 * i], b[3 * i + 1], b[3 * i + 2]};
        for (std::uint32_t e = rows_[i].begin; e < rows_[i].end; ++e)
          subtract_product(sum, blocks_[e], &x[3 * nodes_[e]]);
        store_product(&x[3 * i], inverse_[i], sum);
      }
    });
}

}  // namespace nanocarbon::multilevel
