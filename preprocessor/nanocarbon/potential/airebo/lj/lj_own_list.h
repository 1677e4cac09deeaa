// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/core/cell.h"
#include "nanocarbon/core/neighbours_within.h"
#include "nanocarbon/potential/airebo/lj/lj_lists.h"

namespace nanocarbon::airebo {

struct LjOwnListOptions {
  double margin = 1.5;                 //!< beyond where the sum ends, Angstrom
  std::uint32_t chunk_clusters = 512;  //!< own clusters in a chunk
};

//! \brief Finds the pairs of a molecule or a crystal.
//! \details Atoms are moved into the cell, and images are made of those near its faces, only in half of all
//! directions, since a pair across a face counts once.
//! \param positions Angstrom, finite
//! \param cell nullptr for free space; may be smaller than the reach
//! \param exclusions images to leave out, for each atom, each pair at one end or both; translations as for
//! the positions given; empty, or one row an atom
LjLists find_lists(std::span<const Vec3> positions, std::span<const Element> elements, const Cell* cell,
                   const NeighbourList& exclusions, const LjParameters& parameters, const LjKernel& kernel,
                   const LjOwnListOptions& options);

//! The translations that LjLists::images stand for, Angstrom.
std::vector<Vec3> translations(const LjLists& lists, const Cell* cell);

}  // namespace nanocarbon::airebo
