// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/potential/rebo2/bond_order.h"
#include "nanocarbon/potential/rebo2/kernels/sp2_kernel.h"

namespace nanocarbon::rebo2 {

//! \brief The C-C potential between 1.2 Angstrom and the cut-off window, for the fast loops.
//! \details V_R and V_A become polynomials through Chebyshev interpolation, whose error is below rounding
//! there.
Sp2Constants make_sp2_constants(const Rebo2Parameters& parameters);

//! The same on another range of bond lengths (Angstrom), without a cut-off.
Sp2Constants make_sp2_constants(const Rebo2Parameters& parameters, double shortest, double longest);

//! T and pi_RC of a bond between three-coordinated carbons among three-coordinated carbons: at (2, 2, 9).
struct Sp2BondConstants {
  double torsion;
  double pi;
};
Sp2BondConstants sp2_bond_constants(const CoordinationTables& tables, double n_conj = 9.0);

//! Whether, with these parameters, whole bonds to three neighbours give whole coordination numbers.
bool sp2_case_applies(const Rebo2Parameters& parameters);

}  // namespace nanocarbon::rebo2
