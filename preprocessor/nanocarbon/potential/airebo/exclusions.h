// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/potential/airebo/parameters.h"
#include "nanocarbon/potential/near_pairs.h"

namespace nanocarbon::airebo {

//! Rows of the bonds of weight 1, of own atoms and copies alike.
potential::NearPairs find_whole_bonds(const potential::AtomsView& atoms, const potential::NearPairs& near,
                                      const AireboParameters& parameters);

//! \brief Pairs joined by up to three whole bonds: C_ij = 0, so they do not contribute to E_LJ.
//! \details In rows of own atoms i, sorted: own atoms j > i and copies j.
potential::NearPairs find_exclusions(std::uint32_t own, const potential::NearPairs& whole_bonds);

//! Whether a pair is among them; i own.
bool is_excluded(const potential::NearPairs& exclusions, std::uint32_t own, std::uint32_t i, std::uint32_t j);

}  // namespace nanocarbon::airebo
