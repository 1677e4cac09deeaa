// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/potential/airebo/lj/lj_lists.h"

namespace nanocarbon::airebo {

//! \brief A half list of neighbours as LAMMPS makes it: each pair once, rows of own atoms, neighbours own or
//! ghosts.
//! \details The rule that decides which end has the pair has already been applied. Indices are those of the positions.
struct LjHalfList {
  std::size_t rows = 0;
  const int* atoms = nullptr;              //!< [row]
  const int* const* neighbours = nullptr;  //!< [atom]
  const int* counts = nullptr;             //!< [atom]
  int neighbour_mask = ~0;                 //!< the bits of a neighbour that are its index
};

//! \brief Arranges a half list by clusters. It is valid as long as the half list is: no pair is left out because of its
//! distance, and LjLists::margin is infinite.
//! \param positions x, y, z of all atoms, ghosts included, Angstrom
//! \param elements of all atoms; only those in the list matter
//! \param exclusions pairs to leave out, an own atom first; each once or at both ends
LjLists lists_from_half_list(const LjHalfList& half, const double* positions,
                             std::span<const Element> elements,
                             std::span<const std::array<std::uint32_t, 2>> exclusions);

}  // namespace nanocarbon::airebo
