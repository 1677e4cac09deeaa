// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>
#include <vector>

#include "nanocarbon/core/cell.h"
#include "nanocarbon/potential/periodic_copies.h"

namespace nanocarbon::airebo {

//! \brief The atoms of a molecule or crystal and the images that act on them.
//! \details Own atoms are moved into the cell, in their order; images follow.
struct Sites {
  std::uint32_t own = 0;
  std::vector<potential::PeriodicCopy> sites;

  std::uint32_t all() const { return static_cast<std::uint32_t>(sites.size()); }
  bool is_copy(std::uint32_t site) const { return site >= own; }
};

//! \param cell nullptr for no periodicity; may hold a single atom
//! \param reach every image within this distance of the cell is included, Angstrom
Sites find_sites(std::span<const Vec3> positions, const Cell* cell, double reach);

//! Writes x, y, z of each site.
void place_sites(std::span<const Vec3> positions, const Cell* cell, const Sites& sites,
                 std::vector<double>& coordinates);

//! Full rows of all sites within a cut-off (Angstrom).
potential::NearPairs find_near_pairs(const std::vector<double>& coordinates, double cutoff);

//! \brief Each pair within a cut-off (Angstrom) once, in the row of an own atom.
//! \details An atom and an image of itself or of another atom are a pair, of which one of the two images that
//! show it is taken.
potential::NearPairs find_half_pairs(const std::vector<double>& coordinates, const Sites& sites,
                                     double cutoff);

}  // namespace nanocarbon::airebo
