// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <span>

#include "nanocarbon/potential/rebo2/parameters.h"
#include "nanocarbon/potential/rebo2/switching.h"

namespace nanocarbon::rebo2 {

//! The angular function g at a point, and its derivatives.
struct AngularValue {
  double value;
  double by_cosine;        //!< d g / d cos(theta)
  double by_coordination;  //!< d g / d N
};

//! A quintic and its derivative, by Horner's rule.
inline ValueSlope evaluate_quintic(const Quintic& c, double x) {
  double value = c[5];
  double slope = 0.0;
  for (int power = 4; power >= 0; --power) {
    slope = slope * x + value;
    value = value * x + c[power];
  }
  return {value, slope};
}

//! The piece of a spline that a point lies in: the upper one at a knot, the first or last outside.
inline std::size_t spline_piece(std::span<const double> knots, double x) {
  std::size_t piece = 0;
  while (piece + 2 < knots.size() && x >= knots[piece + 1]) ++piece;
  return piece;
}

//! g_C for few neighbours, as three-coordinated carbon has it (Brenner et al. 2002, section 2.3).
inline ValueSlope angular_carbon_few(const CarbonAngles& carbon, double cosine) {
  return evaluate_quintic(carbon.few[spline_piece(carbon.knots, cosine)], cosine);
}

//! \brief g_C: switches from the branch for few neighbours to that for many by a cosine in the coordination.
//! \param coordination of the central atom without the bond's other end, N_ij
inline AngularValue angular_carbon(const CarbonAngles& carbon, double cosine, double coordination) {
  const std::size_t piece = spline_piece(carbon.knots, cosine);
  if (coordination <= carbon.few_end) {
    const ValueSlope few = evaluate_quintic(carbon.few[piece], cosine);
    return {few.value, few.slope, 0.0};
  }
  const ValueSlope many = evaluate_quintic(carbon.many[piece], cosine);
  if (coordination >= carbon.many_begin) return {many.value, many.slope, 0.0};
  const ValueSlope few = evaluate_quintic(carbon.few[piece], cosine);
  const ValueSlope share = cosine_switch(coordination, carbon.few_end, carbon.many_begin);
  return {many.value + share.value * (few.value - many.value),
          many.slope + share.value * (few.slope - many.slope), share.slope * (few.value - many.value)};
}

//! g_H, which does not depend on the coordination.
inline AngularValue angular_hydrogen(const HydrogenAngles& hydrogen, double cosine) {
  const ValueSlope g = evaluate_quintic(hydrogen.pieces[spline_piece(hydrogen.knots, cosine)], cosine);
  return {g.value, g.slope, 0.0};
}

}  // namespace nanocarbon::rebo2
