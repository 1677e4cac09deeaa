// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/lj/lj_constants.h"

#include <cmath>
#include <numbers>

namespace nanocarbon::airebo {

namespace {

//! Calls do(own element, hydrogen lanes, lane, pair) for all of them.
template <class Action>
void for_all_lanes(const Action& action) {
  for (std::size_t own = 0; own < 2; ++own)
    for (std::size_t hydrogens = 0; hydrogens < 16; ++hydrogens)
      for (int lane = 0; lane < lj_lanes; ++lane) action(own, hydrogens, lane, own + (hydrogens >> lane & 1));
}

LjShape in_angstrom(LjShape shape, double scale, double strength) {
  const double scale_4 = scale * scale * scale * scale;
  for (double& c : shape.well) c *= strength / scale_4;
  for (double& c : shape.steep) c *= strength / (scale_4 * scale * scale * scale);
  shape.to_switch = std::sqrt(scale);
  shape.cutoff_squared /= scale;
  return shape;
}

}  // namespace

LjConstants make_lj_constants(const LjParameters& parameters) {
  // Without a window the switch never begins, and the cut-off does all.
  const bool window = parameters.switch_end > parameters.switch_begin;
  const double width = window ? parameters.switch_end - parameters.switch_begin : 1.0;
  LjConstants c = {};
  c.begin = window ? parameters.switch_begin / width : 1e300;
  const double inverse_width_6 = std::pow(width, -6);
  c.slope_to_a = -std::numbers::ln2 / 3.0;
  for_all_lanes([&](std::size_t own, std::size_t hydrogens, int lane, std::size_t pair) {
    const LjPairParameters& p = parameters.pairs[pair];
    LjPairLanes& to = c.pair[own][hydrogens];
    const double unit = p.sigma * width;
    to.scale[lane] = 1.0 / (unit * unit);
    if (parameters.form == LjForm::morse) {
      to.strength[lane] = 6.0 * p.morse_epsilon * to.scale[lane];
      to.slope[lane] = -p.morse_decay * unit / std::numbers::ln2;
      to.offset[lane] = p.morse_decay * p.morse_equilibrium / std::numbers::ln2;
    } else {
      to.strength[lane] = 24.0 * p.epsilon * to.scale[lane] * inverse_width_6;
    }
  });
  const double cutoff = std::min(parameters.cutoff, parameters.switch_end) / width;
  c.scaled = {1.0,
              {2.0 * inverse_width_6, (2.0 + c.begin) * inverse_width_6, -3.0 * inverse_width_6},
              {1.0, 1.0 + c.begin, -1.0},
              cutoff * cutoff};
  const LjPairLanes& carbons = c.pair[0][0];
  c.carbon = in_angstrom(c.scaled, carbons.scale[0], carbons.strength[0]);
  return c;
}

LjVariant lj_variant(const LjParameters& parameters, bool energy, bool mixed) {
  return {parameters.form == LjForm::morse, energy, mixed,
          parameters.cutoff < parameters.switch_end || parameters.switch_end <= parameters.switch_begin};
}

void set_reach(LjSearch& search, const LjParameters& parameters, double margin) {
  for_all_lanes([&](std::size_t own, std::size_t hydrogens, int lane, std::size_t pair) {
    const double reach = lj_reach(parameters, pair) + margin;
    search.reach_squared[own][hydrogens][lane] = reach * reach;
  });
}

}  // namespace nanocarbon::airebo
