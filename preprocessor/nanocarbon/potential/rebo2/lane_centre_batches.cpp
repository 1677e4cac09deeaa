// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/lane_centre_batches.h"

namespace nanocarbon::rebo2 {

namespace {

constexpr std::uint32_t counts = lane_most_bonds + 1;  // of bonds to one element

}  // namespace

LaneCentreBatches::LaneCentreBatches() : batches_(std::size_t{4} * counts * counts) {}

void LaneCentreBatches::clear() {
  for (const std::uint32_t used : used_) batches_[used].first.clear();
  used_.clear();
}

void LaneCentreBatches::add(const LaneCentres& centre, std::uint32_t first) {
  const std::uint32_t key =
      ((2u * centre.hydrogen + centre.whole) * counts + static_cast<std::uint32_t>(centre.carbons)) * counts +
      static_cast<std::uint32_t>(centre.hydrogens);
  Batch& batch = batches_[key];
  if (batch.first.empty()) {
    used_.push_back(key);
    batch.centres = centre;
  }
  batch.first.push_back(first);
}

void LaneCentreBatches::finish() {
  for (const std::uint32_t used : used_) {
    Batch& batch = batches_[used];
    batch.centres.count = batch.first.size();
    while (batch.first.size() % lane_block != 0) batch.first.push_back(batch.first.back());
    batch.centres.first = batch.first.data();
  }
}

}  // namespace nanocarbon::rebo2
