// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/core/thread_team.h"
#include "nanocarbon/minimisation/multilevel/interpolation.h"
#include "nanocarbon/minimisation/multilevel/symmetric_block.h"

namespace nanocarbon::multilevel {

//! \brief P^T A P for an interpolation P, with what can be kept from one A to the next.
class GalerkinProduct {
 public:
  GalerkinProduct() = default;
  //! \param team may be null; outlives the product
  GalerkinProduct(const NodeGraph& pattern, const Interpolation& interpolation, std::size_t coarse_nodes,
                  ThreadTeam* team = nullptr);

  //! Nodes of each row of the product, sorted, the row's own included.
  const NodeGraph& pattern() const { return pattern_; }
  //! The blocks of the product, in its pattern's order.
  //! \param pattern,interpolation those of the constructor
  std::vector<Block> blocks(const NodeGraph& pattern, const RowOf& row_of,
                            const Interpolation& interpolation) const;

 private:
  struct Chunk {
    std::uint32_t begin, end;         // coarse rows
    std::vector<std::uint32_t> rows;  // fine rows that they are made of
  };
  struct Scratch;
  void compute_chunk(const Chunk& chunk, const NodeGraph& pattern, const RowOf& row_of,
                     const Interpolation& interpolation, std::vector<Block>& product, Scratch& scratch) const;

  NodeGraph pattern_;
  std::vector<Chunk> chunks_;
  ThreadTeam* team_ = nullptr;
};

}  // namespace nanocarbon::multilevel
