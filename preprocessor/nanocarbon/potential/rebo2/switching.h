// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cmath>
#include <numbers>

namespace nanocarbon::rebo2 {

//! A function of one variable at a point.
struct ValueSlope {
  double value;
  double slope;
};

//! 1 up to begin, 0 from end on, half a cosine wave between them (Brenner et al. 2002, equation 20).
inline ValueSlope cosine_switch(double x, double begin, double end) {
  const double t = (x - begin) / (end - begin);
  if (t <= 0.0) return {1.0, 0.0};
  if (t >= 1.0) return {0.0, 0.0};
  constexpr double pi = std::numbers::pi;
  return {0.5 * (1.0 + std::cos(pi * t)), -0.5 * pi * std::sin(pi * t) / (end - begin)};
}

//! 1 up to begin, 0 from end on, the cubic 1 - t^2 (3 - 2 t) between them (Stuart et al. 2000, equation 8).
inline ValueSlope cubic_switch(double x, double begin, double end) {
  const double t = (x - begin) / (end - begin);
  if (t <= 0.0) return {1.0, 0.0};
  if (t >= 1.0) return {0.0, 0.0};
  return {1.0 - t * t * (3.0 - 2.0 * t), 6.0 * t * (t - 1.0) / (end - begin)};
}

}  // namespace nanocarbon::rebo2
