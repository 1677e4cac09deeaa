// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/potential/airebo/parameters.h"
#include "nanocarbon/potential/rebo2/bond_order.h"

namespace nanocarbon::airebo {

//! What the evaluation of a term needs besides the atoms.
struct AireboModel {
  AireboModel(const AireboParameters& p, const AireboTerms& t)
      : parameters(p),
        terms(t),
        lj(lj_parameters(p, t)),
        rebo(parameters.rebo, t.torsion ? &parameters.torsion : nullptr) {}
  AireboModel(const AireboModel&) = delete;
  AireboModel& operator=(const AireboModel&) = delete;

  AireboParameters parameters;
  AireboTerms terms;
  LjParameters lj;
  rebo2::Model rebo;
};

//! The longest bond, fractional ones included, Angstrom.
double longest_bond(const AireboParameters& parameters);

//! The largest distance at which b* may matter for some pair, Angstrom.
double longest_hypothetical_bond(const AireboParameters& parameters);

//! \brief How far from an own atom bonds matter, Angstrom.
//! \details Along paths of three bonds, and up to two bonds beyond the far end of a pair whose b* matters.
double bond_reach(const AireboParameters& parameters);

//! The largest distance at which E_LJ acts on some pair, Angstrom; 0 without it.
double long_range_reach(const AireboModel& model);

}  // namespace nanocarbon::airebo
