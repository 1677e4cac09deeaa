// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/sp2_order_bound.h"

#include <Eigen/Dense>
#include <algorithm>

#include "nanocarbon/potential/rebo2/angular_spline.h"

namespace nanocarbon::airebo {

namespace {

constexpr int powers = 7;
constexpr int lanes = 8;
constexpr double top = 0.5;  // g rises steeply beyond, where the polynomial need not follow

double polynomial(const std::array<double, powers>& c, double x) {
  x = x < top ? x : top;
  return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * (c[5] + x * c[6])))));
}

}  // namespace

Sp2OrderBound::Sp2OrderBound(const rebo2::CarbonAngles& carbon) {
  constexpr double three_bonds = 3.0;
  const auto g = [&](double cosine) { return rebo2::angular_carbon(carbon, cosine, three_bonds).value; };
  constexpr int samples = 400;
  Eigen::MatrixXd matrix(samples + 1, powers);
  Eigen::VectorXd values(samples + 1);
  for (int s = 0; s <= samples; ++s) {
    const double x = -1.0 + (top + 1.0) * s / samples;
    values[s] = g(x);
    double power = 1.0;
    for (int p = 0; p < powers; ++p, power *= x) matrix(s, p) = power;
  }
  const Eigen::VectorXd fitted = matrix.colPivHouseholderQr().solve(values);
  std::copy(fitted.begin(), fitted.end(), polynomial_.begin());
  // Down by as much as it is above anywhere, and by what may be between two samples.
  double above = 0.0, between = 0.0, last = 0.0;
  for (int s = 0; s <= 8 * samples; ++s) {
    const double x = -1.0 + 2.0 * s / (8 * samples);
    const double difference = below_g(x) - g(x);
    above = std::max(above, difference);
    if (s > 0) between = std::max(between, std::abs(difference - last));
    last = difference;
  }
  polynomial_[0] -= above + between;
}

double Sp2OrderBound::below_g(double cosine) const { return polynomial(polynomial_, cosine); }

void Sp2OrderBound::find_high(std::span<const TrigonalPair> pairs, double limit,
                              std::vector<std::uint32_t>& high) const {
  // (p_i + p_j)^2 = 1/s_i + 1/s_j + 2 / sqrt(s_i s_j) is to be at most (2 limit)^2, without the root.
  const double most = 4.0 * limit * limit;
  for (std::size_t first = 0; first < pairs.size(); first += lanes) {
    const std::size_t count = std::min<std::size_t>(lanes, pairs.size() - first);
    alignas(64) double along[3][lanes], at_i[9][lanes], at_j[9][lanes], sum_i[lanes], sum_j[lanes],
        low[lanes];
    for (std::size_t l = 0; l < lanes; ++l) {
      const TrigonalPair& pair = pairs[first + std::min(l, count - 1)];
      for (int d = 0; d < 3; ++d) along[d][l] = pair.along[d];
      for (int d = 0; d < 9; ++d) at_i[d][l] = pair.i->along[d];
      for (int d = 0; d < 9; ++d) at_j[d][l] = pair.j->along[d];
      sum_i[l] = pair.i->base;
      sum_j[l] = pair.j->base;
    }
    for (int b = 0; b < 9; b += 3)
      for (int l = 0; l < lanes; ++l) {
        sum_i[l] += polynomial(polynomial_, at_i[b][l] * along[0][l] + at_i[b + 1][l] * along[1][l] +
                                                at_i[b + 2][l] * along[2][l]);
        sum_j[l] += polynomial(polynomial_, -(at_j[b][l] * along[0][l] + at_j[b + 1][l] * along[1][l] +
                                              at_j[b + 2][l] * along[2][l]));
      }
    for (int l = 0; l < lanes; ++l) {
      const double product = 1.0 / (sum_i[l] * sum_j[l]);
      const double room = most - (sum_i[l] + sum_j[l]) * product;
      // All three above zero.
      const double least = std::min(std::min(sum_i[l], sum_j[l]), room);
      low[l] = least > 0.0 ? room * room - 4.0 * product : -1.0;
    }
    for (std::size_t l = 0; l < count; ++l)
      if (!(low[l] >= 0.0)) high.push_back(static_cast<std::uint32_t>(first + l));
  }
}

}  // namespace nanocarbon::airebo
