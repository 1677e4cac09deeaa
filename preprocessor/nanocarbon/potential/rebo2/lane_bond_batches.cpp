// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/lane_bond_batches.h"

#include <algorithm>

namespace nanocarbon::rebo2 {

namespace {

constexpr std::uint32_t counts = lane_most_bonds + 1;  // of arms

}  // namespace

LaneBondBatches::LaneBondBatches() : batches_(3 + std::size_t{2} * counts * counts) {}

void LaneBondBatches::clear() {
  for (const std::uint32_t used : used_) {
    LaneBondBatch& batch = batches_[used];
    batch.bonds.count = 0;
    batch.edges.clear();
    batch.arms.clear();
    batch.reverses.clear();
    batch.numbers.clear();
  }
  used_.clear();
}

void LaneBondBatches::add(const LaneBondTerms& bond) {
  const std::uint32_t key =
      bond.dihedrals ? 3 + ((bond.triangles ? counts : 0u) + bond.arms_i) * counts + bond.arms_j : bond.pair;
  LaneBondBatch& batch = batches_[key];
  const std::size_t most = bond.dihedrals ? bond.arms.size() : 0;
  const std::size_t place = batch.bonds.count++;
  const std::size_t block = place / lane_block, lane = place % lane_block;
  if (place == 0) {
    used_.push_back(key);
    batch.bonds = {.pair = static_cast<int>(bond.pair),
                   .dihedrals = bond.dihedrals,
                   .triangles = bond.dihedrals && bond.triangles,
                   .arms_i = bond.dihedrals ? static_cast<int>(bond.arms_i) : 0,
                   .arms_j = bond.dihedrals ? static_cast<int>(bond.arms_j) : 0,
                   .count = 1,
                   .edges = nullptr,
                   .arms = nullptr,
                   .numbers = nullptr};
  }
  if (lane == 0) {
    // Lanes that stay empty repeat this bond, with no share in it.
    batch.edges.resize((block + 1) * lane_block, bond.edge);
    batch.reverses.resize((block + 1) * lane_block, bond.reverse);
    batch.numbers.resize((block + 1) * lane_pieces * lane_block, 0.0);
    batch.arms.resize((block + 1) * most * lane_block);
    for (std::size_t a = 0; a < most; ++a)
      std::fill_n(batch.arms.begin() + static_cast<std::ptrdiff_t>((block * most + a) * lane_block),
                  lane_block, bond.arms[a]);
  }
  batch.edges[place] = bond.edge;
  batch.reverses[place] = bond.reverse;
  for (std::size_t a = 0; a < most; ++a) batch.arms[(block * most + a) * lane_block + lane] = bond.arms[a];
  for (std::size_t piece = 0; piece < lane_pieces; ++piece)
    batch.numbers[(block * lane_pieces + piece) * lane_block + lane] = bond.numbers[piece];
}

void LaneBondBatches::keep_numbers() {
  for (const std::uint32_t used : used_) batches_[used].kept = batches_[used].numbers;
}

void LaneBondBatches::restore_numbers() {
  for (const std::uint32_t used : used_) batches_[used].numbers = batches_[used].kept;
}

}  // namespace nanocarbon::rebo2
