// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "nanocarbon/potential/airebo/model.h"
#include "nanocarbon/potential/near_pairs.h"

namespace nanocarbon::airebo {

//! \brief An atom whose bonds are all whole, prepared for p of hypothetical bonds in many directions.
struct BondStar {
  static constexpr std::uint32_t most_bonds = 4;

  std::uint32_t atom;
  std::uint32_t bonds;
  std::array<std::uint32_t, most_bonds> neighbours;
  std::array<double, 2> base;                           //!< 1 + P by the element of the other end
  std::array<std::array<double, 3>, most_bonds> along;  //!< unit vectors
  std::array<double, most_bonds> stretch;               //!< at hydrogen exp(4 (rho - r)), else 1
  std::uint64_t step;                                   //!< that along and stretch are of
};

//! \brief Bounds of b* without its dihedrals and conjugation.
//! \details b* = (p_ij + p_ji)/2 + F + T S, where for whole bonds F depends on N_conj alone and T S is not
//! above zero: cheap to bound, and nearly always far below where S_b begins to switch.
class BondStars {
 public:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  explicit BondStars(const AireboModel& model);

  void clear() { stars_.clear(); }
  //! \return the number of the new star, or none where an atom has too many bonds
  std::uint32_t add(std::uint32_t atom, const potential::AtomsView& atoms,
                    const potential::NearPairs& whole_bonds);
  //! Marks all positions as out of date.
  void new_step() { ++step_; }
  //! Brings a star up to date with the atoms' positions, unless it is already.
  void place(std::uint32_t star, const potential::AtomsView& atoms) {
    if (stars_[star].step != step_) place_star(stars_[star], atoms);
  }
  //! \brief Not below b* of two atoms, provided their bonds are those of the stars.
  //! \pre both are placed
  //! \param along unit vector from i to j
  double order_bound(std::uint32_t star_i, std::uint32_t star_j, const std::array<double, 3>& along,
                     const potential::AtomsView& atoms) const;

 private:
  void place_star(BondStar& star, const potential::AtomsView& atoms);
  double sum(const BondStar& star, Element element, Element other, const std::array<double, 3>& along) const;

  const AireboModel& model_;
  std::vector<BondStar> stars_;
  std::uint64_t step_ = 1;
  //! The largest F + T S by pair_index() and the ends' coordinations.
  std::array<std::array<std::array<double, BondStar::most_bonds + 1>, BondStar::most_bonds + 1>, 3> most_;
  std::array<double, 2> fictitious_;  // at hydrogen, exp(-4 (rho - r_min)) by the other end's element
};

}  // namespace nanocarbon::airebo
