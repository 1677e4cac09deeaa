// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>

#include "nanocarbon/potential/airebo/lj/lj_parameters.h"
#include "nanocarbon/potential/rebo2/parameters.h"

namespace nanocarbon::airebo {

//! Parameters of E_LJ for one pair of elements (Stuart et al. 2000, equations 7 to 14).
struct LongRangeParameters {
  double
      length_switch_begin;    //!< S(t_r): up to here the bond order decides whether the pair repels, Angstrom
  double length_switch_end;   //!< from here on it does not matter, Angstrom
  double order_switch_begin;  //!< S(t_b): pairs of a smaller b* repel in full
  double order_switch_end;    //!< pairs of a larger b* are bonded and do not
  LjPairParameters potential;  //!< Morse is zero in AIREBO
};

//! \brief Every parameter of AIREBO or AIREBO-M.
//! \details S. J. Stuart, A. B. Tutein, J. A. Harrison, J. Chem. Phys. 112, 6472 (2000); for the Morse form
//! T. C. O'Connor, J. Andzelm, M. O. Robbins, J. Chem. Phys. 142, 024903 (2015). The numbers are those of
//! LAMMPS's CH.airebo and CH.airebo-m.
struct AireboParameters {
  LjForm form;
  rebo2::Rebo2Parameters rebo;                    //!< not those of REBO2: H-H, rounding and P_CC differ
  std::array<LongRangeParameters, 3> long_range;  //!< by pair_index()
  rebo2::TorsionBarriers torsion;
  double graphene_energy;  //!< per atom of a flat, relaxed sheet, eV; from LAMMPS
  double benzene_energy;   //!< relaxed, eV; from LAMMPS
};

//! \brief Which terms of AIREBO are wanted, and how far E_LJ reaches: the arguments of LAMMPS's `pair_style
//! airebo CUT [LJ TORSION [MIN]]`.
//! \details Lengths are multiples of a pair's sigma. As in LAMMPS, E_LJ is switched off between 2.16 and 3
//! whatever the cut-off is: a smaller one cuts it with a jump, a larger one changes nothing. Only a given MIN
//! moves the switch, to MIN..CUT.
struct AireboTerms {
  double cutoff = 3.0;
  bool long_range = true;  //!< E_LJ
  bool torsion = true;     //!< E_torsion
  double switch_begin = 2.16;
  double switch_end = 3.0;
};

//! The plain pair potential of E_LJ.
LjParameters lj_parameters(const AireboParameters& parameters, const AireboTerms& terms);

//! AIREBO (2000).
const AireboParameters& airebo_parameters();
//! AIREBO-M (2015).
const AireboParameters& airebo_m_parameters();

//! \brief AIREBO's splines over coordination numbers.
//! \details Those of REBO2 except for P_CC (table VIII of Stuart et al. 2000 with LAMMPS's corrections).
const rebo2::CoordinationTables& airebo_tables();

}  // namespace nanocarbon::airebo
