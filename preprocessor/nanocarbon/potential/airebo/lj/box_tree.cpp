// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/lj/box_tree.h"

#include <algorithm>

namespace nanocarbon::airebo {

namespace {

//! Not a number, and so near, where a corner is not a number.
double squared_distance(const Box& a, const Box& b) {
  double sum = 0.0;
  for (int d = 0; d < 3; ++d) {
    const double below = a.low[d] - b.high[d], above = b.low[d] - a.high[d];
    const double gap = below > above ? below : above;
    sum += gap < 0.0 ? 0.0 : gap * gap;
  }
  return sum;
}

}  // namespace

BoxTree::BoxTree(std::vector<Box> boxes) {
  levels_.push_back(std::move(boxes));
  while (levels_.back().size() > 1) {
    const std::vector<Box>& below = levels_.back();
    std::vector<Box> level;
    for (std::size_t begin = 0; begin < below.size(); begin += fan) {
      Box around = below[begin];
      for (std::size_t b = begin + 1; b < std::min(begin + fan, below.size()); ++b) {
        around.low = around.low.cwiseMin(below[b].low);
        around.high = around.high.cwiseMax(below[b].high);
      }
      level.push_back(around);
    }
    levels_.push_back(std::move(level));
  }
}

void BoxTree::find(const Box& box, double reach, std::uint32_t first,
                   std::vector<std::uint32_t>& found) const {
  if (first < levels_.front().size()) find_below(levels_.size() - 1, 0, box, reach * reach, first, found);
}

void BoxTree::find_below(std::size_t level, std::uint32_t node, const Box& box, double reach_squared,
                         std::uint32_t first, std::vector<std::uint32_t>& found) const {
  if (squared_distance(levels_[level][node], box) > reach_squared) return;
  if (level == 0) {
    found.push_back(node);
    return;
  }
  const std::uint32_t leaves = 1u << 2 * (level - 1);  // under each child
  static_assert(fan == 4);
  const auto end = std::min<std::size_t>(fan * (node + 1), levels_[level - 1].size());
  for (std::uint32_t child = fan * node; child < end; ++child)
    if (std::uint64_t{leaves} * (child + 1) > first)
      find_below(level - 1, child, box, reach_squared, first, found);
}

}  // namespace nanocarbon::airebo
