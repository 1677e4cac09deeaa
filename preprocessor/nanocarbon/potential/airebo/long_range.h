// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "nanocarbon/potential/airebo/bond_paths.h"
#include "nanocarbon/potential/airebo/hypothetical_bond.h"
#include "nanocarbon/potential/airebo/model.h"

namespace nanocarbon::airebo {

//! \brief A part of E_LJ of one pair: share (c - w) V(r) slw(r) [d - S_r (1 - S_b)].
//! \details All of it is C_ij V slw [1 - S_r (1 - S_b)] (Stuart et al. 2000, equations 7 to 13), where S_r
//! switches over r, S_b over the hypothetical bond order b*, and C_ij = 1 - w, with w the weight of the best
//! path: that is c = d = 1. Other values of c and d give what is missing from a sum that assumed C_ij or S_b.
struct LongRangeTerm {
  std::uint32_t i;
  std::uint32_t j;
  double c = 1.0;
  double d = 1.0;
  double share = 1.0;            //!< 1/2 where the pair is evaluated at both ends
  std::optional<BondPath> path = {};  //!< from i to j
};

//! Finds the bonds that the term's b* depends on, if it depends on b* at all.
void add_bonds_for(const LongRangeTerm& term, const potential::AtomsView& atoms,
                   const potential::NearPairs& near, const AireboModel& model, rebo2::HalfEdges& edges);

//! \brief Adds a term's derivatives to half-edges and forces.
//! \pre add_bonds_for() was called
//! \return its energy, eV
double add_long_range_term(const LongRangeTerm& term, const potential::AtomsView& atoms,
                           const AireboModel& model, rebo2::HalfEdges& edges,
                           HypotheticalBondScratch& scratch, double* forces,
                           const potential::AtomShares& shares);

}  // namespace nanocarbon::airebo
