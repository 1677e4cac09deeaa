// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "nanocarbon/core/neighbours_within.h"
#include "nanocarbon/potential/airebo/neighbours.h"

namespace nanocarbon::airebo {

//! A molecule or crystal with its images: which atoms are near each other by some earlier positions, and where they
//! are now.
class Arrangement {
 public:
  //! \param skin of near pairs, Angstrom
  explicit Arrangement(double skin) : skin_(skin) {}

  //! \brief Makes everything from scratch.
  //! \param reach of images;
  //! \param bond of near pairs, without their skin;
  //! \param pair_reach of pairs; all in Angstrom
  void make(std::span<const Vec3> positions, std::span<const Element> elements, const Cell* cell,
            double reach, double bond, double pair_reach);
  //! Whether it was made for these atoms in this cell, at whatever positions.
  bool is_of(std::span<const Element> elements, const Cell* cell) const;
  //! Takes new positions of the same atoms.
  //! \pre is_of()
  void place(std::span<const Vec3> positions, const Cell* cell) {
    place_sites(positions, cell, sites_, coordinates_);
  }
  //! Whether no atom has moved by more than half the skin since near pairs were searched for.
  bool near_is_good(std::span<const Vec3> positions) const;
  //! Searches for near pairs again.
  //! \pre place() or make() with the same positions
  void find_near(std::span<const Vec3> positions);

  const Sites& sites() const { return sites_; }
  potential::AtomsView view() const {
    return {coordinates_.data(), elements_.data(), sites_.own, sites_.all()};
  }
  const potential::NearPairs& near() const { return near_; }
  //! Each pair once, see find_half_pairs().
  const potential::NearPairs& pairs() const { return pairs_; }
  //! Rows of own atoms as neighbours of the atoms where they are given.
  NeighbourList as_neighbours(const potential::NearPairs& rows) const;

 private:
  double skin_;
  double bond_ = 0.0;
  Sites sites_;
  std::vector<Element> elements_;    // of all sites
  std::vector<double> coordinates_;  // of all sites
  potential::NearPairs near_;
  potential::NearPairs pairs_;
  std::vector<Vec3> near_positions_;  // of the atoms when near pairs were looked for
  std::optional<Cell> cell_;
  bool made_ = false;
};

}  // namespace nanocarbon::airebo
