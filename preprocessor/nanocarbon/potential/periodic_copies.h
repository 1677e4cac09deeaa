// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "nanocarbon/core/cell.h"
#include "nanocarbon/potential/near_pairs.h"

namespace nanocarbon::potential {

//! A periodic image of an own atom, as an atom in its own right.
struct PeriodicCopy {
  std::uint32_t of;
  std::array<std::int32_t, 3> image;
};

//! Near pairs of a periodic (or free) system, with the copies that they need.
struct NearAtoms {
  std::uint32_t own = 0;
  std::vector<PeriodicCopy> copies;  //!< copy c is atom own + c
  NearPairs pairs;
};

//! \brief Finds all pairs within a cut-off, and makes copies of atoms up to three bonds across the cell's faces.
//! \param cell nullptr for no periodicity
//! \param cutoff Angstrom
NearAtoms find_near_atoms(std::span<const Vec3> positions, const Cell* cell, double cutoff);

//! Writes x, y, z of own atoms and copies one after the other.
void place_atoms(std::span<const Vec3> positions, const Cell* cell, const NearAtoms& near,
                 std::vector<double>& coordinates);

}  // namespace nanocarbon::potential
