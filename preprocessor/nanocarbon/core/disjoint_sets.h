// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace nanocarbon {

//! \brief Disjoint sets of the numbers below a count (union-find with path halving).
//! \details A set's root is its lowest member. Members may also be known to be alike or opposite to the
//! others of their set; where nothing is said they are alike.
class DisjointSets {
 public:
  struct Place {
    std::uint32_t root;
    bool opposite;  //!< to the root
  };

  explicit DisjointSets(std::size_t members) : parent_(members), opposite_(members, 0) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  //! The root of a member's set.
  std::uint32_t find(std::uint32_t member) { return place(member).root; }

  Place place(std::uint32_t member) {
    std::uint8_t opposite = 0;
    while (parent_[member] != member) {
      const std::uint32_t up = parent_[member];
      opposite_[member] ^= opposite_[up];  // of a root it is zero
      parent_[member] = parent_[up];
      opposite ^= opposite_[member];
      member = parent_[member];
    }
    return {member, opposite != 0};
  }

  //! Joins two members' sets so that the two are alike, or opposite. False where they were in one set and
  //! known to be otherwise; the set then stays as it is.
  bool join(std::uint32_t a, std::uint32_t b, bool opposite = false) {
    const Place pa = place(a), pb = place(b);
    const bool roots_opposite = (pa.opposite != pb.opposite) != opposite;
    if (pa.root == pb.root) return !roots_opposite;
    const auto [low, high] = std::minmax(pa.root, pb.root);
    parent_[high] = low;
    opposite_[high] = roots_opposite;
    return true;
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> opposite_;  // to the parent
};

}  // namespace nanocarbon
