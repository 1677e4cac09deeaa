// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "nanocarbon/potential/rebo2/bond_order.h"
#include "nanocarbon/potential/rebo2/conjugation.h"

namespace nanocarbon::airebo {

//! \brief The bond order b* that two atoms would have if they were bonded where they are, and what its
//! derivatives need.
//! \details Stuart et al. 2000, section II C: the bond order of REBO at r_ij = r_min, along the real
//! direction. An existing bond between them is left out of the sums, as for b itself. The length r_min
//! matters only in lambda at hydrogen.
struct HypotheticalBond {
  rebo2::HalfEdge ij;  //!< of weight w(r), zero where the atoms are not bonded
  rebo2::HalfEdge ji;
  rebo2::HalfBondOrder p_ij;
  rebo2::HalfBondOrder p_ji;
  rebo2::WholeBondOrder whole;
  double order() const { return 0.5 * (p_ij.value + p_ji.value) + whole.value(); }
};

//! What a bond's derivatives need from its evaluation.
struct HypotheticalBondScratch {
  std::vector<rebo2::AngleTerm> angles_i;
  std::vector<rebo2::AngleTerm> angles_j;
};

//! The geometry of an atom seen from another, with the weight of a bond between them.
rebo2::HalfEdge half_edge(const potential::AtomsView& atoms, std::uint32_t from, std::uint32_t to,
                          const rebo2::Rebo2Parameters& parameters);

//! \param ij from half_edge()
//! \pre the bonds of both atoms and of their neighbours have been found
HypotheticalBond evaluate_hypothetical_bond(rebo2::HalfEdges& edges, std::uint32_t i,
                                            const rebo2::HalfEdge& ij, const rebo2::Model& model,
                                            HypotheticalBondScratch& scratch);

//! \brief Adds the derivatives of an energy that depends on b*.
//! \details Those by the atoms' bonds go to the half-edges, those by the direction of i-j to the forces.
//! \param by_order dE/db*, eV
void add_hypothetical_bond_derivatives(rebo2::HalfEdges& edges, std::uint32_t i, HypotheticalBond& bond,
                                       double by_order, const rebo2::Model& model,
                                       const HypotheticalBondScratch& scratch, double* forces,
                                       const potential::AtomShares& shares);

}  // namespace nanocarbon::airebo
