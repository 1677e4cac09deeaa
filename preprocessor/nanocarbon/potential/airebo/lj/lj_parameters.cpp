// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/lj/lj_parameters.h"

#include <algorithm>
#include <cmath>

namespace nanocarbon::airebo {

double lj_reach(const LjParameters& parameters, std::size_t pair) {
  return std::min(parameters.cutoff, parameters.switch_end) * parameters.pairs[pair].sigma;
}

LjValue lj_value(const LjParameters& parameters, std::size_t pair, double r) {
  const LjPairParameters& p = parameters.pairs[pair];
  if (r >= lj_reach(parameters, pair)) return {0.0, 0.0};
  LjValue v;
  if (parameters.form == LjForm::morse) {
    const double y = std::exp(-p.morse_decay * (r - p.morse_equilibrium));
    v = {p.morse_epsilon * y * (y - 2.0), -2.0 * p.morse_decay * p.morse_epsilon * y * (y - 1.0)};
  } else {
    const double q = p.sigma / r, q3 = q * q * q, q6 = q3 * q3;
    v = {4.0 * p.epsilon * q6 * (q6 - 1.0), -24.0 * p.epsilon * q6 * (2.0 * q6 - 1.0) / r};
  }
  const double begin = parameters.switch_begin * p.sigma;
  if (r <= begin) return v;
  const double width = parameters.switch_end * p.sigma - begin;
  const double t = (r - begin) / width;
  const double slw = (1.0 - t) * (1.0 - t) * (1.0 + 2.0 * t);
  const double slope = -6.0 * t * (1.0 - t) / width;
  return {v.energy * slw, v.slope * slw + v.energy * slope};
}

}  // namespace nanocarbon::airebo
