// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/potential/rebo2/parameters.h"

namespace nanocarbon::airebo {

//! \brief A carbon atom with three whole bonds, as hypothetical bonds to other carbons see it.
//! \details Two lines of a cache.
struct alignas(64) TrigonalCarbon {
  std::array<double, 9> along;    //!< unit vectors of its bonds
  std::array<double, 3> inverse;  //!< of their lengths, 1/Angstrom
  double base;                    //!< 1 + P_CC
  std::uint64_t step;             //!< that along and inverse are of
  std::uint32_t atom;
  std::array<std::uint32_t, 3> neighbours;
};

//! Two of them, and the unit vector from the first to the second.
struct TrigonalPair {
  const TrigonalCarbon* i;
  const TrigonalCarbon* j;
  std::array<double, 3> along;
};

//! \brief Sorts out pairs of three-bonded carbons whose (p_ij + p_ji)/2 is surely low.
//! \details Nearly all pairs of facing sheets are. Instead of the spline g a polynomial below it is taken, so
//! that loops over several pairs need no branches.
class Sp2OrderBound {
 public:
  explicit Sp2OrderBound(const rebo2::CarbonAngles& carbon);

  //! \param limit of (p_ij + p_ji)/2
  //! \param high numbers of those pairs that may be above the limit are appended
  void find_high(std::span<const TrigonalPair> pairs, double limit, std::vector<std::uint32_t>& high) const;

  //! Not above g at three bonds, for any cosine.
  double below_g(double cosine) const;

 private:
  std::array<double, 7> polynomial_;  // in the cosine, from the constant term on
};

}  // namespace nanocarbon::airebo
