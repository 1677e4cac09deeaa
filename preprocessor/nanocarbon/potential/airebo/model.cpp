// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/model.h"

#include <algorithm>

namespace nanocarbon::airebo {

double longest_bond(const AireboParameters& parameters) {
  double longest = 0.0;
  for (const rebo2::PairParameters& pair : parameters.rebo.pairs)
    longest = std::max(longest, pair.cutoff_end);
  return longest;
}

double longest_hypothetical_bond(const AireboParameters& parameters) {
  double longest = 0.0;
  for (const LongRangeParameters& pair : parameters.long_range)
    longest = std::max(longest, pair.length_switch_end);
  return longest;
}

double bond_reach(const AireboParameters& parameters) {
  const double bond = longest_bond(parameters);
  return std::max(3.0 * bond, longest_hypothetical_bond(parameters) + 2.0 * bond);
}

double long_range_reach(const AireboModel& model) {
  double reach = 0.0;
  if (model.terms.long_range)
    for (int p = 0; p < 3; ++p) reach = std::max(reach, lj_reach(model.lj, p));
  return reach;
}

}  // namespace nanocarbon::airebo
