// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/core/vec3.h"

namespace nanocarbon {

//! \brief Points hashed by the bin that they are in: linear in points for any extent of the coordinates.
//! \details What is looked at of the points of a bin lies side by side.
class PointBuckets {
 public:
  using Bin = std::array<std::int64_t, 3>;

  struct Entry {
    std::uint64_t key;
    Vec3 position;
    std::uint32_t point;
  };

  //! \param bin_of bin of the point of that index
  template <class BinOf>
  PointBuckets(std::span<const Vec3> points, const BinOf& bin_of) {
    start_.assign(buckets_for(points.size()) + 1, 0);
    entries_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) ++start_[bucket_of(packed(bin_of(i))) + 1];
    for (std::size_t b = 0; b + 1 < start_.size(); ++b) start_[b + 1] += start_[b];
    std::vector<std::uint32_t> fill(start_.begin(), start_.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::uint64_t key = packed(bin_of(i));
      entries_[fill[bucket_of(key)]++] = {key, points[i], static_cast<std::uint32_t>(i)};
    }
  }

  //! Calls visit(entry) for the points of one bin, in their order.
  template <class Visit>
  void for_each_in(const Bin& bin, const Visit& visit) const {
    const std::uint64_t key = packed(bin);
    const std::size_t bucket = bucket_of(key);
    for (std::uint32_t slot = start_[bucket]; slot < start_[bucket + 1]; ++slot)
      if (entries_[slot].key == key) visit(entries_[slot]);
  }

 private:
  static std::size_t buckets_for(std::size_t points);

  // A bin as one number. Bins two million apart share it; distances tell those apart.
  static std::uint64_t packed(const Bin& bin) {
    constexpr std::uint64_t mask = (std::uint64_t{1} << 21) - 1;
    return (static_cast<std::uint64_t>(bin[0]) & mask) << 42 |
           (static_cast<std::uint64_t>(bin[1]) & mask) << 21 | (static_cast<std::uint64_t>(bin[2]) & mask);
  }

  static std::uint64_t hash(std::uint64_t key) {
    key *= 0x9e3779b97f4a7c15ull;
    key ^= key >> 32;
    key *= 0xff51afd7ed558ccdull;
    return key ^ key >> 32;
  }

  std::size_t bucket_of(std::uint64_t key) const {
    return static_cast<std::size_t>(hash(key)) & (start_.size() - 2);
  }

  std::vector<std::uint32_t> start_;  // one more than there are buckets, a power of two
  std::vector<Entry> entries_;
};

inline std::size_t PointBuckets::buckets_for(std::size_t points) {
  std::size_t count = 16;
  while (count < 2 * points) count *= 2;
  return count;
}

}  // namespace nanocarbon
