// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "nanocarbon/potential/rebo2/kernels/lane_kernel.h"

namespace nanocarbon::rebo2 {

//! \brief Atoms sorted by what the lane loops must do for them: by element, numbers of bonds, and whether these are whole.
//! \details Arrays are reused from step to step.
class LaneCentreBatches {
 public:
  LaneCentreBatches();

  void clear();
  //! \param centre all but LaneCentres::first and count
  //! \param first the atom's first half-edge
  void add(const LaneCentres& centre, std::uint32_t first);
  //! Fills blocks up. To be called when all have been added.
  void finish();
  //! The batches, in the order in which they came up.
  template <class Take>
  void for_each(const Take& take) const {
    for (const std::uint32_t used : used_) take(batches_[used].centres);
  }

 private:
  struct Batch {
    LaneCentres centres = {};
    std::vector<std::uint32_t> first;
  };
  std::vector<Batch> batches_;
  std::vector<std::uint32_t> used_;
};

}  // namespace nanocarbon::rebo2
