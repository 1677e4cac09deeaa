// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "nanocarbon/core/element.h"

namespace nanocarbon::airebo {

//! The pair potential V of the long-range sum: AIREBO's, or AIREBO-M's.
enum class LjForm { lennard_jones, morse };

//! Parameters of one pair of elements.
struct LjPairParameters {
  double epsilon = 0.0;            //!< eV
  double sigma = 0.0;              //!< Angstrom; also the unit of the switch and the cut-off
  double morse_epsilon = 0.0;      //!< eV
  double morse_decay = 0.0;        //!< alpha, 1/Angstrom
  double morse_equilibrium = 0.0;  //!< r_eq, Angstrom
};

//! \brief V(r) slw(r) for carbon and hydrogen.
//! \details V = 4 epsilon [(sigma/r)^12 - (sigma/r)^6], or epsilon_M y (y - 2), y = exp(-alpha (r - r_eq)).
//! slw = 1 - t^2 (3 - 2 t), where t goes from 0 at switch_begin to 1 at switch_end.
//! \pre epsilon and sigma above zero; 0 < switch_begin <= switch_end
struct LjParameters {
  std::array<LjPairParameters, 3> pairs;  //!< C-C, C-H, H-H
  LjForm form = LjForm::lennard_jones;
  double switch_begin = 2.16;  //!< in units of sigma
  double switch_end = 3.0;     //!< in units of sigma
  double cutoff = 3.0;         //!< pairs from here on are left out, with a jump where it is below switch_end

  static constexpr std::size_t index(Element a, Element b) {
    return static_cast<std::size_t>(a) + static_cast<std::size_t>(b);
  }
};

//! Where the sum ends for a pair (0 C-C, 1 C-H, 2 H-H), Angstrom.
double lj_reach(const LjParameters& parameters, std::size_t pair);

struct LjValue {
  double energy;  //!< eV
  double slope;   //!< d energy / d r, eV/Angstrom
};

//! V slw at a distance r (Angstrom); zero from the reach on.
LjValue lj_value(const LjParameters& parameters, std::size_t pair, double r);

}  // namespace nanocarbon::airebo
