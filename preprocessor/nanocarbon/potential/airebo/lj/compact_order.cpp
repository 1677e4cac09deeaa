// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/lj/compact_order.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace nanocarbon::airebo {

namespace {

using Indices = std::span<std::uint32_t>;

class Halving {
 public:
  Halving(std::span<const Vec3> points, std::size_t run) : points_(points), run_(run), keys_(points.size()) {}

  void sort(Indices part) {
    while (part.size() > run_) {
      const std::size_t runs = (part.size() + run_ - 1) / run_, half = runs / 2 * run_;
      split(part, half);
      sort(part.first(half));
      part = part.subspan(half);
    }
    std::sort(part.begin(), part.end());
  }

 private:
  void split(Indices part, std::size_t half) {
    Vec3 low = points_[part.front()], high = low;
    for (const std::uint32_t p : part) {
      low = low.cwiseMin(points_[p]);
      high = high.cwiseMax(points_[p]);
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    // With their numbers, so that the halves do not depend on how a library selects among equals.
    const auto keys = std::span(keys_).first(part.size());
    for (std::size_t k = 0; k < part.size(); ++k) keys[k] = {points_[part[k]][axis], part[k]};
    std::nth_element(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(half), keys.end());
    for (std::size_t k = 0; k < part.size(); ++k) part[k] = keys[k].second;
  }

  std::span<const Vec3> points_;
  std::size_t run_;
  std::vector<std::pair<double, std::uint32_t>> keys_;
};

}  // namespace

std::vector<std::uint32_t> compact_order(std::span<const Vec3> points, std::size_t run) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto end = std::stable_partition(order.begin(), order.end(),
                                         [&](std::uint32_t p) { return points[p].allFinite(); });
  Halving(points, run).sort({order.begin(), end});
  return order;
}

}  // namespace nanocarbon::airebo
