// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/kept_pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "nanocarbon/core/chunks.h"
#include "nanocarbon/core/neighbours_within.h"

namespace nanocarbon {

namespace {

// Blocks are paired where their boxes are this much farther apart than atoms are looked for, Angstrom.
constexpr double box_skin = 6;
// Atoms are divided anew once a block is so many times as long as it was at most.
constexpr double most_stretch = 2.5;

constexpr double never_listed = std::numeric_limits<double>::infinity();

bool same(const auto& one, const auto& other) {
  return one.first == other.first && one.second == other.second;
}

}  // namespace

void KeptPairs::divide(std::span<const Vec3> positions) {
  blocks_.divide(positions);
  checked_.assign(positions.begin(), positions.end());
  left_ = 0;
  pairs_.clear();
  paired_boxes_.clear();
}

void KeptPairs::measure_boxes(std::span<const Vec3> positions, ThreadTeam* team) {
  boxes_.resize(blocks_.all().size());
  constexpr std::size_t at_once = 64;
  for_each_index(team, (boxes_.size() + at_once - 1) / at_once, [&](std::size_t part) {
    for (std::size_t b = part * at_once; b < std::min(boxes_.size(), (part + 1) * at_once); ++b) {
      Box box{Vec3::Constant(never_listed), Vec3::Constant(-never_listed)};
      for (const std::uint32_t a : blocks_.atoms(b)) {
        box.low = box.low.cwiseMin(positions[a]);
        box.high = box.high.cwiseMax(positions[a]);
      }
      boxes_[b] = box;
    }
  });
}

// Whether blocks that are not paired may have come as near as atoms are looked for. What all blocks move does not count.
bool KeptPairs::boxes_have_moved() const {
  if (paired_boxes_.size() != boxes_.size()) return true;
  Vec3 shift = Vec3::Zero();
  for (std::size_t b = 0; b < boxes_.size(); ++b)
    shift += (boxes_[b].low - paired_boxes_[b].low) / static_cast<double>(boxes_.size());
  for (std::size_t b = 0; b < boxes_.size(); ++b)
    if (!((boxes_[b].low - paired_boxes_[b].low - shift).cwiseAbs().maxCoeff() <= box_skin / 2 &&
          (boxes_[b].high - paired_boxes_[b].high - shift).cwiseAbs().maxCoeff() <= box_skin / 2))
      return true;
  return false;
}

void KeptPairs::find_block_pairs(ThreadTeam* team) {
  const double apart = reach_ + margin_ + box_skin;
  double longest = 0;
  std::vector<Vec3> centres;
  for (const Box& box : boxes_) {
    centres.push_back(0.5 * (box.low + box.high));
    longest = std::max(longest, (box.high - box.low).maxCoeff());
  }
  const NeighbourList near =
      neighbours_within(centres, nullptr, std::sqrt(3.0) * (longest + apart) + 1e-6, team);
  std::vector<BlockPair> found;
  auto former = pairs_.begin();
  const auto add = [&](std::uint32_t first, std::uint32_t second) {
    while (former != pairs_.end() && std::tie(former->first, former->second) < std::tie(first, second))
      ++former;
    BlockPair& pair = found.emplace_back(BlockPair{first, second, never_listed, {}});
    if (former != pairs_.end() && same(*former, pair)) pair = std::move(*former);
  };
  for (std::uint32_t b = 0; b < boxes_.size(); ++b) {
    add(b, b);
    for (const Neighbour& n : near.of(b))
      if (n.atom > b && (boxes_[b].low - boxes_[n.atom].high).maxCoeff() < apart &&
          (boxes_[n.atom].low - boxes_[b].high).maxCoeff() < apart)
        add(b, n.atom);
  }
  pairs_ = std::move(found);
  paired_boxes_ = boxes_;
}

void KeptPairs::list(BlockPair& pair, std::span<const Vec3> positions, const Wanted& wanted) const {
  const double cutoff = reach_ + margin_, squared = cutoff * cutoff;
  pair.used = 0;
  pair.atoms.clear();
  const Box& box = boxes_[pair.second];
  const bool within = pair.first == pair.second;
  for (const std::uint32_t a : blocks_.atoms(pair.first)) {
    const Vec3& at = positions[a];
    if (((box.low - at).array() > cutoff).any() || ((at - box.high).array() > cutoff).any()) continue;
    for (const std::uint32_t b : blocks_.atoms(pair.second))
      if ((!within || b > a) && (positions[b] - at).squaredNorm() < squared && wanted(a, b))
        pair.atoms.emplace_back(a, b);
  }
}

bool KeptPairs::update(std::span<const Vec3> positions, const Wanted& wanted, ThreadTeam* team) {
  if (checked_.size() != positions.size()) divide(positions);
  const double moved = largest_in_chunks(team, positions.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t a = begin; a < end; ++a)
      if (!((positions[a] - checked_[a]).squaredNorm() <= 0.25 * left_ * left_)) return 1.0;
    return 0.0;
  });
  if (moved == 0 && !pairs_.empty()) return false;
  blocks_.set_from(checked_, team);
  blocks_.fit(checked_, positions, team);
  measure_boxes(positions, team);
  for (const Box& box : boxes_)
    if (!((box.high - box.low).maxCoeff() <= most_stretch * block_side)) {
      divide(positions);
      measure_boxes(positions, team);
      break;
    }
  if (!pairs_.empty()) {
    const std::vector<RigidBlock>& all = blocks_.all();
    for_chunks(team, pairs_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
        pairs_[k].used += approach(all[pairs_[k].first], all[pairs_[k].second]);
    });
  }
  if (boxes_have_moved()) find_block_pairs(team);
  checked_.assign(positions.begin(), positions.end());
  const bool stale =
      std::any_of(pairs_.begin(), pairs_.end(), [&](const BlockPair& p) { return !(p.used <= margin_); });
  if (stale)
    for_each_index(team, pairs_.size(), [&](std::size_t k) {
      // Some of those that hold still are done as well: there is time until the next.
      if (!(pairs_[k].used <= 0.5 * margin_)) list(pairs_[k], positions, wanted);
    });
  left_ = margin_;
  for (const BlockPair& pair : pairs_) left_ = std::min(left_, margin_ - pair.used);
  return stale;
}

void KeptPairs::rows(std::vector<std::size_t>& offsets, std::vector<std::uint32_t>& near) const {
  offsets.assign(checked_.size() + 1, 0);
  for (const BlockPair& pair : pairs_)
    for (const auto& [a, b] : pair.atoms) {
      ++offsets[a + 1];
      ++offsets[b + 1];
    }
  for (std::size_t a = 0; a < checked_.size(); ++a) offsets[a + 1] += offsets[a];
  near.resize(offsets.back());
  std::vector<std::size_t> fill(offsets.begin(), offsets.end() - 1);
  for (const BlockPair& pair : pairs_)
    for (const auto& [a, b] : pair.atoms) {
      near[fill[a]++] = b;
      near[fill[b]++] = a;
    }
  for (std::size_t a = 0; a < checked_.size(); ++a)
    std::sort(near.begin() + static_cast<std::ptrdiff_t>(offsets[a]),
              near.begin() + static_cast<std::ptrdiff_t>(offsets[a + 1]));
}

}  // namespace nanocarbon
