// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/potential/rebo2/bond_order.h"

namespace nanocarbon::rebo2 {

//! pi_RC + T S of a bond, and what its derivatives need.
struct WholeBondOrder {
  TricubicValue pi;
  TricubicValue torsion;                   //!< zero where LAMMPS drops it
  double dihedrals;                        //!< S
  std::array<double, 2> conjugation_sums;  //!< for each end, the sum whose square enters N_conj
  std::array<double, 3> slope;             //!< derivatives by N_ij, N_ji and N_conj

  double value() const { return pi.value + torsion.value * dihedrals; }
  bool flat() const { return slope[0] == 0.0 && slope[1] == 0.0 && slope[2] == 0.0; }
};

//! \brief Evaluates pi_RC + T S.
//! \param ij a bond between the centres i and j, or a hypothetical one; its weight is what it contributes to their
//! sums
WholeBondOrder whole_bond_order(HalfEdges& edges, const Centre& i, const HalfEdge& ij, const Centre& j,
                                const Model& model);

//! Adds the derivatives of strength (eV) times the value.
void add_whole_bond_order_derivatives(HalfEdges& edges, const Centre& i, HalfEdge& ij, const Centre& j,
                                      const WholeBondOrder& order, double strength, const Model& model,
                                      const potential::AtomShares& shares);

//! \brief The terms of a bond as a whole: w V_A (pi_RC + T S), and the torsion energy if the model has it.
//! \details pi_RC = F(N_ij, N_ji, N_conj) (Brenner et al. 2002, equation 13), for C-C bonds also T(...) times
//! the sum over dihedrals. N_conj = 1 + (sum over carbons k of w_ik F(N_k - w_ik))^2 + the same for j
//! (equation 15). The half-edges of both ends must have been added, and those of neighbours that do not have
//! three whole bonds. Derivatives are added to them.
//! \param share 1, or 1/2 if two processes (or two images) both evaluate this bond
EnergyParts add_bond_terms(HalfEdges& edges, const Centre& i, HalfEdge& ij, const Model& model, double share,
                           const potential::AtomShares& shares);

}  // namespace nanocarbon::rebo2
