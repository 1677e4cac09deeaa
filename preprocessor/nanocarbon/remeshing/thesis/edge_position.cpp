// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/edge_position.h"

#include <array>
#include <cmath>
#include <numbers>

namespace nanocarbon::thesis {

double star_length_error(const Vec3& vertex, std::span<const Vec3> neighbours, double m) {
  double sum = 0.0;
  for (const Vec3& n : neighbours) {
    const double difference = (vertex - n).norm() - m;
    sum += difference * difference;
  }
  return sum;
}

double least_error_position(const Vec3& a, const Vec3& b, std::span<const Vec3> neighbours, double m) {
  const auto error = [&](double t) { return star_length_error(a + t * (b - a), neighbours, m); };
  // From the middle outwards, so that the middle wins where both sides are equal up to rounding.
  constexpr std::array<double, 7> samples = {0.5, 1.0 / 3.0, 2.0 / 3.0, 1.0 / 6.0, 5.0 / 6.0, 0.0, 1.0};
  double best = samples[0], best_error = error(best);
  for (const double t : samples)
    if (const double e = error(t); e < best_error * (1.0 - 1e-9)) best = t, best_error = e;

  double low = std::max(0.0, best - 1.0 / 6.0), high = std::min(1.0, best + 1.0 / 6.0);
  constexpr double section = std::numbers::phi - 1.0;
  double left = high - section * (high - low), right = low + section * (high - low);
  double error_left = error(left), error_right = error(right);
  while (high - low > 1e-3) {
    if (error_left < error_right) {
      high = right, right = left, error_right = error_left;
      left = high - section * (high - low), error_left = error(left);
    } else {
      low = left, left = right, error_left = error_right;
      right = low + section * (high - low), error_right = error(right);
    }
  }
  const double refined = 0.5 * (low + high);
  return error(refined) < best_error * (1.0 - 1e-9) ? refined : best;
}

}  // namespace nanocarbon::thesis
