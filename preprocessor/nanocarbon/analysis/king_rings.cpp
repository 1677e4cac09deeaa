// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/analysis/king_rings.h"

#include <algorithm>

namespace nanocarbon::analysis {
namespace {

class KingSearch {
 public:
  explicit KingSearch(int max_ring) : max_ring_(max_ring) {}

  void operator()(UnfoldedSurroundings& around, FoundRings& found) {
    const auto near = around.neighbours(0);
    const std::vector<std::uint32_t> neighbours(near.begin(), near.end());
    for (std::size_t i = 0; i < neighbours.size(); ++i)
      for (std::size_t j = i + 1; j < neighbours.size(); ++j)
        if (neighbours[i] != neighbours[j]) shortest_between(around, neighbours[i], neighbours[j], found);
  }

 private:
  // Breadth first from one neighbour to the other, then back along all shortest ways.
  void shortest_between(UnfoldedSurroundings& around, std::uint32_t from, std::uint32_t to,
                        FoundRings& found) {
    level_.assign(level_.size(), unreached);
    reach(from, 0);
    front_.assign(1, from);
    int length = 0;
    while (level_of(to) == unreached && !front_.empty() && length < max_ring_ - 2) {
      ++length;
      after_.clear();
      for (const std::uint32_t place : front_)
        for (const std::uint32_t next : around.neighbours(place))
          if (next != 0 && level_of(next) == unreached) {
            reach(next, static_cast<std::uint8_t>(length));
            after_.push_back(next);
          }
      front_.swap(after_);
    }
    if (level_of(to) == unreached) return;
    ring_.assign(static_cast<std::size_t>(length) + 2, 0);
    ring_.back() = to;
    walk_back(around, ring_.size() - 1, found);
  }

  void walk_back(UnfoldedSurroundings& around, std::size_t at, FoundRings& found) {
    const std::uint8_t level = level_of(ring_[at]);
    if (level == 0) {
      if (is_lowest(around)) found.add(around, ring_);
      return;
    }
    const auto near = around.neighbours(ring_[at]);
    for (const std::uint32_t next : std::vector<std::uint32_t>(near.begin(), near.end()))
      if (next != 0 && level_of(next) == level - 1) {
        ring_[at - 1] = next;
        walk_back(around, at - 1, found);
      }
  }

  // Whether no lower atom finds this ring as well.
  bool is_lowest(UnfoldedSurroundings& around) {
    const std::size_t size = ring_.size();
    for (std::size_t k = 1; k < size; ++k)
      if (around.atom(ring_[k]) < around.atom(0) &&
          !around.is_nearer(ring_[k - 1], ring_[(k + 1) % size], static_cast<int>(size) - 2, ring_[k]))
        return false;
    return true;
  }

  static constexpr std::uint8_t unreached = 255;
  std::uint8_t level_of(std::uint32_t place) const {
    return place < level_.size() ? level_[place] : unreached;
  }
  void reach(std::uint32_t place, std::uint8_t level) {
    if (place >= level_.size()) level_.resize(place + 1, unreached);
    level_[place] = level;
  }

  int max_ring_;
  std::vector<std::uint8_t> level_;
  std::vector<std::uint32_t> front_, after_, ring_;
};

}  // namespace

RingStatistics king_rings(const BondRows& rows, const RingSearchOptions& options) {
  return search_at_all_atoms(rows, options, [&]() -> RingsAtAtom { return KingSearch(options.max_ring); });
}

}  // namespace nanocarbon::analysis
