// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>

#include "nanocarbon/core/thread_team.h"
#include "nanocarbon/minimisation/multilevel/node_graph.h"
#include "nanocarbon/minimisation/multilevel/symmetric_block.h"

namespace nanocarbon::multilevel {

//! x, y, z of all nodes in a row. Single precision is enough for what only prepares a step.
using Displacements = std::vector<float>;

//! \brief Block Gauss-Seidel sweeps over a matrix, in single precision.
//! \details Nodes are swept in chunks that follow each other in an order of their own: chunks that are not coupled
//! are swept at once, whatever the number of threads.
class Smoother {
 public:
  Smoother() = default;
  //! \param pattern nodes of each row, the row's own included
  //! \param team may be null; outlives the smoother
  explicit Smoother(const NodeGraph& pattern, ThreadTeam* team = nullptr);

  //! \pre diagonal blocks are positive definite
  void set(const NodeGraph& pattern, const RowOf& row_of);

  //! x by one sweep from zero, and the residual b - A x that it leaves.
  void sweep_from_zero(const Displacements& b, Displacements& x, Displacements& residual) const;
  //! One sweep more, the other way round.
  void sweep_back(const Displacements& b, Displacements& x) const;

 private:
  std::uint32_t begin_of(std::uint32_t chunk) const;
  std::uint32_t end_of(std::uint32_t chunk) const;

  struct Row {
    std::uint32_t begin, middle, end;  // entries swept before the node, and after it
  };
  std::vector<Row> rows_;
  std::vector<std::uint32_t> nodes_, place_;  // of each entry, and its place in the pattern's row
  std::vector<SymmetricBlock<float>> blocks_, inverse_;
  std::vector<std::vector<std::uint32_t>> colours_;  // chunks of each
  ThreadTeam* team_ = nullptr;
};

}  // namespace nanocarbon::multilevel
