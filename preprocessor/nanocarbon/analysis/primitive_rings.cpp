// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/analysis/primitive_rings.h"

#include <algorithm>

namespace nanocarbon::analysis {
namespace {

// Rings whose lowest atom is the one that the search starts at. Their two halves are shortest paths from there to
// the atom, or the bond, in the middle.
class PrimitiveSearch {
 public:
  explicit PrimitiveSearch(int max_ring) : max_ring_(max_ring) {}

  void operator()(UnfoldedSurroundings& around, FoundRings& found) {
    around_ = &around;
    found_ = &found;
    find_levels();
    for (const std::uint32_t place : std::vector<std::uint32_t>(order_)) {
      const int level = level_[place];
      if (level == 0 || !is_allowed(place)) continue;
      if (2 * level <= max_ring_) rings_with_middle(place, level);
      if (2 * level + 1 <= max_ring_) rings_with_middle_bond(place, level);
    }
  }

 private:
  void find_levels() {
    level_.assign(1, 0);
    order_.assign(1, 0);
    for (std::size_t k = 0; k < order_.size(); ++k) {
      const std::uint32_t place = order_[k];
      if (level_[place] >= max_ring_ / 2) break;
      for (const std::uint32_t next : around_->neighbours(place)) {
        if (level_of(next) != unreached) continue;
        if (next >= level_.size()) level_.resize(next + 1, unreached);
        level_[next] = static_cast<std::uint8_t>(level_[place] + 1);
        order_.push_back(next);
      }
    }
  }

  // Copies, because the surroundings may grow while they are in use.
  std::vector<std::uint32_t> at_level(std::uint32_t place, int level) {
    std::vector<std::uint32_t> result;
    for (const std::uint32_t next : around_->neighbours(place))
      if (level_of(next) == level && is_allowed(next)) result.push_back(next);
    return result;
  }

  void rings_with_middle(std::uint32_t middle, int level) {
    if (level < 2) return;
    ring_.assign(2 * static_cast<std::size_t>(level), 0);
    ring_[level] = middle;
    const std::vector<std::uint32_t> before = at_level(middle, level - 1);
    for (std::size_t i = 0; i < before.size(); ++i)
      for (std::size_t j = i + 1; j < before.size(); ++j) descend(before[i], before[j], level - 1);
  }

  void rings_with_middle_bond(std::uint32_t place, int level) {
    ring_.assign(2 * static_cast<std::size_t>(level) + 1, 0);
    for (const std::uint32_t other : at_level(place, level))
      if (other > place) descend(place, other, level);
  }

  // Two places as far from the start as each other, one on each half.
  void descend(std::uint32_t left, std::uint32_t right, int level) {
    const int size = static_cast<int>(ring_.size());
    if (left == right || around_->is_nearer(left, right, std::min(2 * level, size - 2 * level))) return;
    ring_[level] = left;
    ring_[size - level] = right;
    if (level == 1) {
      if (!is_cut_short()) found_->add(*around_, ring_);
      return;
    }
    const std::vector<std::uint32_t> rights = at_level(right, level - 1);
    for (const std::uint32_t a : at_level(left, level - 1))
      for (const std::uint32_t b : rights) descend(a, b, level - 1);
  }

  // Where opposite atoms are as far apart as along the ring, all are.
  bool is_cut_short() {
    const std::size_t size = ring_.size(), half = size / 2;
    for (std::size_t k = 0; k < (size % 2 == 0 ? half : size); ++k)
      if (around_->is_nearer(ring_[k], ring_[(k + half) % size], static_cast<int>(half))) return true;
    return false;
  }

  static constexpr std::uint8_t unreached = 255;
  int level_of(std::uint32_t place) const { return place < level_.size() ? level_[place] : unreached; }
  bool is_allowed(std::uint32_t place) const { return around_->atom(place) >= around_->atom(0); }

  int max_ring_;
  UnfoldedSurroundings* around_ = nullptr;
  FoundRings* found_ = nullptr;
  std::vector<std::uint8_t> level_;
  std::vector<std::uint32_t> order_, ring_;
};

}  // namespace

RingStatistics primitive_rings(const BondRows& rows, const RingSearchOptions& options) {
  return search_at_all_atoms(rows, options,
                             [&]() -> RingsAtAtom { return PrimitiveSearch(options.max_ring); });
}

}  // namespace nanocarbon::analysis
