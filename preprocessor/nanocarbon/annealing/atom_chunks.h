// SPDX-License-Identifier: GPL-2.0-or-later
// What parts of a molecule threads may work on at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "nanocarbon/annealing/fixed_bond_graph.h"
#include "nanocarbon/core/chunks.h"

namespace nanocarbon::annealing {

//! \brief The inner atoms of a graph in chunks of consecutive ones.
//! \details Work on a chunk may add to the gradients of its atoms and of their neighbours: no other chunk that
//! is worked on at the same time does. The order in which each atom's gradient is added to does not depend on
//! the number of threads.
class AtomChunks {
 public:
  //! Small molecules are one chunk.
  static constexpr std::size_t size = 2048;

  AtomChunks() = default;
  explicit AtomChunks(const FixedBondGraph& graph);

  std::size_t count() const { return count_; }
  std::size_t begin(std::size_t chunk) const { return chunk * size; }
  std::size_t end(std::size_t chunk) const { return std::min(atoms_, (chunk + 1) * size); }

  //! Calls work(chunk) for every chunk.
  template <typename Work>
  void for_each(ThreadTeam* team, const Work& work) const {
    for (const std::vector<std::uint32_t>& colour : colours_)
      for_each_index(team, colour.size(), [&](std::size_t k) { work(colour[k]); });
  }

  //! The sum of what work(chunk) returns.
  template <typename Work>
  double sum(ThreadTeam* team, const Work& work) const {
    std::vector<double> parts(count_);
    for_each(team, [&](std::size_t chunk) { parts[chunk] = work(chunk); });
    double sum = 0;
    for (const double part : parts) sum += part;
    return sum;
  }

 private:
  std::size_t atoms_ = 0, count_ = 0;
  std::vector<std::vector<std::uint32_t>> colours_;
};

}  // namespace nanocarbon::annealing
