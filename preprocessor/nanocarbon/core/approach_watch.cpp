// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/approach_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "nanocarbon/core/chunks.h"

namespace nanocarbon {

void ApproachWatch::set(std::span<const Vec3> positions) {
  reference_.assign(positions.begin(), positions.end());
  checked_ = reference_;
  left_ = margin_;
  blocks_ = {};
}

// How much closer than at the reference two atoms near each other may be at most; infinite where atoms that were
// not may now be.
double ApproachWatch::largest_approach(std::span<const Vec3> positions, ThreadTeam* team) {
  if (blocks_.empty()) {
    adjacent_ = blocks_.divide(reference_);
    blocks_.set_from(reference_, team);
  }
  Vec3 mean_shift = Vec3::Zero();
  for (std::size_t a = 0; a < positions.size(); ++a) mean_shift += positions[a] - reference_[a];
  mean_shift /= static_cast<double>(positions.size());
  const double apart2 = largest_in_chunks(team, positions.size(), [&](std::size_t begin, std::size_t end) {
    double largest = 0;
    for (std::size_t a = begin; a < end; ++a)
      largest = std::max(largest, (positions[a] - reference_[a] - mean_shift).squaredNorm());
    return largest;
  });
  // Atoms of blocks that do not touch were at least a block's side apart.
  if (!(2 * std::sqrt(apart2) <= block_side - reach_ - margin_))
    return std::numeric_limits<double>::infinity();
  blocks_.fit(reference_, positions, team);
  double largest = 0;
  for (const RigidBlock& block : blocks_.all()) largest = std::max(largest, 2 * block.spread);
  for (const auto& [first, second] : adjacent_)
    largest = std::max(largest, approach(blocks_.all()[first], blocks_.all()[second]));
  return largest;
}

bool ApproachWatch::may_be_closer(std::span<const Vec3> positions, bool whole_parts, ThreadTeam* team) {
  if (reference_.empty() || reference_.size() != positions.size()) return true;
  const double moved = largest_in_chunks(team, positions.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t a = begin; a < end; ++a)
      if (!((positions[a] - checked_[a]).squaredNorm() <= 0.25 * left_ * left_)) return 1.0;
    return 0.0;
  });
  if (moved == 0) return false;
  if (!whole_parts) return true;
  const double left = margin_ - largest_approach(positions, team);
  if (!(left >= 0)) return true;
  checked_.assign(positions.begin(), positions.end());
  left_ = left;
  return false;
}

}  // namespace nanocarbon
