// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cmath>

#include "nanocarbon/potential/rebo2/parameters.h"
#include "nanocarbon/potential/rebo2/switching.h"

namespace nanocarbon::rebo2 {

//! V_R = (1 + Q/r) A exp(-alpha r) without its cut-off, eV and eV/Angstrom (Brenner et al. 2002, equation 5).
inline ValueSlope pair_repulsion(const PairParameters& p, double r) {
  const double decay = p.repulsion * std::exp(-p.repulsion_decay * r);
  const double screening = p.screening / r;
  return {(1.0 + screening) * decay, -decay * (p.repulsion_decay * (1.0 + screening) + screening / r)};
}

//! V_A = -sum B_n exp(-beta_n r) without its cut-off, below zero, eV and eV/Angstrom (equation 6).
inline ValueSlope pair_attraction(const PairParameters& p, double r) {
  ValueSlope sum = {0.0, 0.0};
  for (int n = 0; n < 3; ++n) {
    if (p.attraction[n] == 0.0) continue;
    const double term = -p.attraction[n] * std::exp(-p.attraction_decay[n] * r);
    sum.value += term;
    sum.slope -= p.attraction_decay[n] * term;
  }
  return sum;
}

//! The weight of a bond of length r: whole below the pair's cut-off window, nothing beyond it.
inline ValueSlope bond_weight(const PairParameters& p, double r) {
  return cosine_switch(r, p.cutoff_begin, p.cutoff_end);
}

}  // namespace nanocarbon::rebo2
