// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <vector>

#include "nanocarbon/potential/airebo/bond_star.h"
#include "nanocarbon/potential/airebo/bond_watch.h"
#include "nanocarbon/potential/airebo/energy_parts.h"
#include "nanocarbon/potential/airebo/long_range.h"
#include "nanocarbon/potential/airebo/trigonal_pairs.h"
#include "nanocarbon/potential/rebo2/mixed_evaluation.h"

namespace nanocarbon::airebo {

//! \brief All of AIREBO except a plain sum over pairs: E_REBO, E_torsion, and the difference of E_LJ from that sum.
//! \details E_LJ = A - B + D. A, which LjSum does, is V(r) slw(r) of all pairs that were not excluded when
//! lists were made: those that no path of up to three whole bonds joined. So it assumes that
//! C_ij is 0 or 1 and S_b = 1. B is V slw S_r (1 - S_b) of the close ones among them; nearly always b* is too small
//! for S_b to switch, which a bound of it shows. D corrects the pairs whose C_ij has changed or is
//! fractional, which are near atoms with a bond that has changed.
//!
//! Results agree with evaluate_general() up to rounding, wherever atoms are.
class FastEvaluation {
 public:
  //! \param model kept by reference
  explicit FastEvaluation(const AireboModel& model);

  //! \brief Sets new lists; to be called whenever the atoms or their numbering have changed.
  //! \param near as for near_changed()
  //! \param candidates each pair that may come within longest_hypothetical_bond() until the next call, once,
  //! in the row of an own atom
  //! \param margin atoms may move by half of it until near_changed() must be called, Angstrom
  void lists_changed(const potential::AtomsView& atoms, const potential::NearPairs& near,
                     potential::NearPairs candidates, double margin);
  //! \brief Sets new near pairs of the same atoms.
  //! \param near rows of own atoms and of copies up to where bonds matter (bond_reach()), within
  //! longest_bond() and the margin
  void near_changed(const potential::AtomsView& atoms, const potential::NearPairs& near);

  //! Pairs that the plain sum must leave out, see find_exclusions(); they change with lists_changed() alone.
  const potential::NearPairs& exclusions() const { return excluded_; }

  //! \param forces x, y, z of every atom, copies included; added to, eV/Angstrom
  //! \return the energy without that of the plain sum
  AireboEnergyParts evaluate(const potential::AtomsView& atoms, const potential::NearPairs& near,
                             double* forces);

  //! The evaluation of E_REBO and E_torsion, for MixedEvaluation::choose().
  rebo2::MixedEvaluation& bonds() { return bonds_; }
  //! Number of own atoms whose bonds the last evaluation left to the general terms.
  std::size_t general_atoms() const { return bonds_.general_atoms(); }
  //! Number of terms of E_LJ that the last evaluation computed one by one, in general form.
  std::size_t single_terms() const { return terms_.size(); }
  //! Bytes held by the arrays that grow with the atoms.
  std::size_t memory() const;

 private:
  struct ClosePair {
    std::uint32_t i;
    std::uint32_t j;
    std::uint32_t star_i;
    std::uint32_t star_j;
    std::uint32_t elements;  // pair_index()
  };

  void find_close_pairs(const potential::AtomsView& atoms);
  std::vector<char> atoms_to_watch(const potential::AtomsView& atoms, const potential::NearPairs& near) const;
  //! Does those of three-bonded carbons at once, and collects the others.
  double collect_bond_order_terms(const potential::AtomsView& atoms, double* forces);
  void find_affected(const potential::AtomsView& atoms, const potential::NearPairs& near);
  void collect_path_terms(const potential::AtomsView& atoms, const potential::NearPairs& near);

  const AireboModel& model_;
  rebo2::MixedEvaluation bonds_;
  BondWatch watch_;
  TrigonalPairs trigonal_;
  BondStars stars_;
  double margin_ = 0.0;

  potential::NearPairs whole_;  // bonds when lists were made
  potential::NearPairs excluded_;
  potential::NearPairs candidates_;  // not excluded
  std::vector<ClosePair> close_;     // that trigonal_ does not take
  std::vector<std::uint32_t> star_of_;
  std::vector<std::array<std::uint32_t, 2>> left_;  // by trigonal_

  std::vector<std::uint32_t> affected_;  // own atoms, some of whose pairs may have another C_ij
  std::vector<char> affected_flag_;
  BondPaths paths_;
  std::vector<LongRangeTerm> terms_;
  rebo2::HalfEdges edges_;
  HypotheticalBondScratch scratch_;
};

}  // namespace nanocarbon::airebo
