// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/lj/hilbert_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace nanocarbon::airebo {

namespace {

constexpr int key_bits = 21;  // of a coordinate

//! The distance along the curve: coordinates to the transposed index in place, then its bits in turns.
std::uint64_t curve_index(std::array<std::uint32_t, 3> x) {
  constexpr std::uint32_t top = 1u << (key_bits - 1);
  for (std::uint32_t q = top; q > 1; q >>= 1) {
    const std::uint32_t below = q - 1;
    for (std::uint32_t& c : x) {
      if (c & q) {
        x[0] ^= below;
      } else {
        const std::uint32_t swap = (x[0] ^ c) & below;
        x[0] ^= swap;
        c ^= swap;
      }
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t flip = 0;
  for (std::uint32_t q = top; q > 1; q >>= 1)
    if (x[2] & q) flip ^= q - 1;
  std::uint64_t index = 0;
  for (int b = key_bits - 1; b >= 0; --b)
    for (const std::uint32_t c : x) index = index << 1 | ((c ^ flip) >> b & 1);
  return index;
}

}  // namespace

std::vector<std::uint32_t> hilbert_order(std::span<const Vec3> points) {
  Vec3 low = Vec3::Constant(INFINITY), high = Vec3::Constant(-INFINITY);
  for (const Vec3& p : points)
    if (p.allFinite()) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  const double extent = points.empty() ? 0.0 : (high - low).maxCoeff();
  const double scale = extent > 0.0 ? ((1u << key_bits) - 1) / extent : 0.0;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(points.size());
  for (std::uint32_t i = 0; i < keys.size(); ++i) {
    std::array<std::uint32_t, 3> x = {0, 0, 0};
    if (points[i].allFinite())
      for (int d = 0; d < 3; ++d) x[d] = static_cast<std::uint32_t>((points[i][d] - low[d]) * scale);
    keys[i] = {curve_index(x), i};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(keys.size());
  std::transform(keys.begin(), keys.end(), order.begin(), [](const auto& key) { return key.second; });
  return order;
}

}  // namespace nanocarbon::airebo
