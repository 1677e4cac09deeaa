// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/coordination_tables.h"

#include <algorithm>
#include <cmath>

namespace nanocarbon::rebo2 {

namespace {

//! A knot interval and where in it a point lies.
struct Place {
  int knot;
  double t;
};

Place place(double x, int first, int last) {
  const double inside = std::clamp(x, static_cast<double>(first), static_cast<double>(last));
  const int knot = std::min(static_cast<int>(inside), last - 1);
  return {knot, inside - knot};
}

//! The four cubic Hermite functions on [0, 1] and their derivatives: values at both ends, then slopes.
struct Hermite {
  std::array<double, 2> value, value_slope;
  std::array<double, 2> slope, slope_slope;

  explicit Hermite(double t)
      : value{1.0 - t * t * (3.0 - 2.0 * t), t * t * (3.0 - 2.0 * t)},
        value_slope{-6.0 * t * (1.0 - t), 6.0 * t * (1.0 - t)},
        slope{t * (1.0 - t) * (1.0 - t), t * t * (t - 1.0)},
        slope_slope{(1.0 - t) * (1.0 - 3.0 * t), t * (3.0 * t - 2.0)} {}
};

}  // namespace

BicubicValue BicubicTable::evaluate(double n_carbon, double n_hydrogen) const {
  const Place c = place(n_carbon, 0, 4);
  const Place h = place(n_hydrogen, 0, 4);
  const Hermite by_c(c.t), by_h(h.t);
  BicubicValue sum = {0.0, {0.0, 0.0}};
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) {
      const double knot = values_[c.knot + a][h.knot + b];
      sum.value += knot * by_c.value[a] * by_h.value[b];
      sum.slope[0] += knot * by_c.value_slope[a] * by_h.value[b];
      sum.slope[1] += knot * by_c.value[a] * by_h.value_slope[b];
    }
  return sum;
}

TricubicValue TricubicTable::evaluate(double n_ij, double n_ji, double n_conj) const {
  const Place i = place(n_ij, 0, 4);
  const Place j = place(n_ji, 0, 4);
  const Place k = place(n_conj, 1, 9);
  const auto whole = [](const Place& p) { return p.t == 0.0 || p.t == 1.0; };
  if (whole(i) && whole(j) && whole(k)) {
    const Knot& knot = at(i.knot + (i.t == 1.0), j.knot + (j.t == 1.0), k.knot + (k.t == 1.0));
    return {knot.value, knot.slope};
  }
  const Hermite x(i.t), y(j.t), z(k.t);
  TricubicValue sum = {0.0, {0.0, 0.0, 0.0}};
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      for (int c = 0; c < 2; ++c) {
        const Knot& knot = at(i.knot + a, j.knot + b, k.knot + c);
        const auto add = [&](double scale, double fx, double dx, double fy, double dy, double fz, double dz) {
          sum.value += scale * fx * fy * fz;
          sum.slope[0] += scale * dx * fy * fz;
          sum.slope[1] += scale * fx * dy * fz;
          sum.slope[2] += scale * fx * fy * dz;
        };
        add(knot.value, x.value[a], x.value_slope[a], y.value[b], y.value_slope[b], z.value[c],
            z.value_slope[c]);
        add(knot.slope[0], x.slope[a], x.slope_slope[a], y.value[b], y.value_slope[b], z.value[c],
            z.value_slope[c]);
        add(knot.slope[1], x.value[a], x.value_slope[a], y.slope[b], y.slope_slope[b], z.value[c],
            z.value_slope[c]);
        add(knot.slope[2], x.value[a], x.value_slope[a], y.value[b], y.value_slope[b], z.slope[c],
            z.slope_slope[c]);
      }
  return sum;
}

}  // namespace nanocarbon::rebo2
