// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/potential/rebo2/kernels/lane_kernel.h"

namespace nanocarbon::rebo2 {

//! A bond that has terms as a whole, by its half-edges.
struct LaneBondTerms {
  std::uint32_t edge, reverse;
  std::uint32_t pair;                   //!< pair_index()
  bool dihedrals;                       //!< else the arms do not matter
  bool triangles;                       //!< an atom is an arm of both ends
  std::uint32_t arms_i, arms_j;         //!< how many
  std::span<const std::uint32_t> arms;  //!< half-edges, those of i first
  std::array<double, std::size_t{lane_pieces}> numbers;
};

//! Bonds that are alike, in the layout of LaneBonds.
struct LaneBondBatch {
  LaneBonds bonds = {};
  std::vector<std::uint32_t> edges, arms, reverses;
  std::vector<double> numbers;  //!< after the loops, derivatives by them
  std::vector<double> kept;     //!< what they were
};

//! Bonds sorted into batches that the lane loops take, an array for each kind that is reused from step to step.
class LaneBondBatches {
 public:
  LaneBondBatches();

  void clear();
  bool empty() const { return used_.empty(); }
  void add(const LaneBondTerms& bond);
  //! Keeps the numbers as they are now,
  void keep_numbers();
  //! and puts them back for the next step.
  void restore_numbers();
  //! The batches that have bonds, in the order in which they came up, ready for the loops.
  template <class Take>
  void for_each(const Take& take) {
    for (const std::uint32_t used : used_) {
      LaneBondBatch& batch = batches_[used];
      batch.bonds.edges = batch.edges.data();
      batch.bonds.arms = batch.arms.data();
      batch.bonds.numbers = batch.numbers.data();
      take(batch);
    }
  }

 private:
  std::vector<LaneBondBatch> batches_;
  std::vector<std::uint32_t> used_;
};

}  // namespace nanocarbon::rebo2
