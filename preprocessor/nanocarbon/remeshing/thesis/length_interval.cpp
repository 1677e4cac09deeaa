// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/length_interval.h"

#include <algorithm>
#include <numbers>

namespace nanocarbon::thesis {

LengthInterval edge_interval(double min_bond, double max_bond) {
  return {min_bond * std::numbers::sqrt3, max_bond * std::numbers::sqrt3};
}

LengthInterval interpolated_interval(const LengthInterval& target, double mean_length) {
  const double centre = std::min(2.0 * mean_length, target.mean());
  const double half_width = std::min(target.half_width(), mean_length);
  return {centre - half_width, centre + half_width};
}

}  // namespace nanocarbon::thesis
