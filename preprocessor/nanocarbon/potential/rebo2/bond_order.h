// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "nanocarbon/potential/atom_shares.h"
#include "nanocarbon/potential/rebo2/angular_spline.h"
#include "nanocarbon/potential/rebo2/coordination_tables.h"
#include "nanocarbon/potential/rebo2/energy_parts.h"
#include "nanocarbon/potential/rebo2/half_edges.h"
#include "nanocarbon/potential/rebo2/parameters.h"
#include "nanocarbon/potential/rebo2/torsion_energy.h"

namespace nanocarbon::rebo2 {

//! What the evaluation of a term needs besides the bonds.
struct Model {
  explicit Model(const Rebo2Parameters& p, const TorsionBarriers* t = nullptr)
      : parameters(p), tables(p.tables), torsion(t) {}
  const Rebo2Parameters& parameters;
  const CoordinationTables& tables;
  const TorsionBarriers* torsion;  //!< of AIREBO's torsion energy; nullptr if not wanted
};

//! An angle at a bond's end, kept between the two passes over a centre's neighbours.
struct AngleTerm {
  double cosine;
  double stretch;  //!< e^lambda
  AngularValue g;
};

//! p_ij of a bond at one end, and what its derivatives need; the angles are kept separately.
struct HalfBondOrder {
  double value;
  double sum_by_coordination;          //!< derivative of the sum over angles, through g
  std::array<double, 2> spline_slope;  //!< of P by N^C and N^H
};

//! \brief p_ij = [1 + sum_k w_ik g(cos theta_jik, N_ij) e^lambda + P_ij]^(-1/2) (Brenner et al. 2002,
//! equation 7).
//! \param bonds of the centre; the one to the same atom as ij is left out
//! \param ij one of them, or a hypothetical bond; its weight is what it contributes to the centre's sums
//! \param length of ij in lambda, Angstrom
HalfBondOrder half_bond_order(std::span<const HalfEdge> bonds, const Centre& centre, const HalfEdge& ij,
                              double length, const Model& model, std::vector<AngleTerm>& angles);

//! \brief Adds the derivatives of an energy that depends on p_ij to the centre's half-edges.
//! \param by_sum dE/d of the sum under the root, eV
//! \param length_is_real whether lambda's length is that of ij
void add_half_bond_order_derivatives(std::span<HalfEdge> bonds, const Centre& centre, HalfEdge& ij,
                                     const HalfBondOrder& order, double by_sum, bool length_is_real,
                                     const std::vector<AngleTerm>& angles,
                                     const potential::AtomShares& shares);

//! \brief The terms centred on one atom: for each of its bonds half the repulsion, and V_A times half p_ij.
//! \details Over both ends of a bond that is V_R + V_A (p_ij + p_ji)/2. Adds derivatives to the centre's
//! half-edges.
EnergyParts add_centre_terms(HalfEdges& edges, const Centre& centre, const Model& model,
                             std::vector<AngleTerm>& scratch, const potential::AtomShares& shares);

}  // namespace nanocarbon::rebo2
