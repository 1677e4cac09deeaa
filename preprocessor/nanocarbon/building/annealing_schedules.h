// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "nanocarbon/annealing/bond_switching.h"
#include "nanocarbon/building/annealed_options.h"

namespace nanocarbon::building {

//! How many times a triangulation can be coarsened to a quarter before too few atoms are left to show a shape; 0 for
//! a draft, which does not anneal.
int refinements_for(std::size_t atoms, Quality quality);

//! What all schedules have in common: number of atoms, seed, threads, and the temperature at their end.
annealing::BondSwitchingOptions schedule_for(std::size_t atoms, const AnnealOptions& options);

//! From where defects move freely: for molecules small enough, or coarse levels of larger ones.
//! \param at_length hotter and slower, except for the smallest molecules
annealing::BondSwitchingOptions hot_schedule(std::size_t atoms, bool at_length, const AnnealOptions& options);

//! For a start at full size.
//! \param alone no refined start has come about
annealing::BondSwitchingOptions full_size_schedule(std::size_t atoms, bool alone,
                                                   const AnnealOptions& options);

//! \brief For a closed surface in a periodic cell of less than 300 atoms.
//! \details Its topology asks for defects, and most trials are at these, in vain: half as many do as elsewhere, and are as
//! well spent where it is so hot that defects find other places.
annealing::BondSwitchingOptions hot_schedule_in_cell(std::size_t atoms, const AnnealOptions& options);

//! The tether of what is refined from a coarse level: it has its order already and is held by a fifth of the default
//! tether, so that it can buckle where that is cheaper, and by all that is asked beyond.
double refined_tether(double tether);

//! For a molecule refined from a coarser level, which is already ordered.
annealing::BondSwitchingOptions refined_schedule(std::size_t atoms, const AnnealOptions& options);

}  // namespace nanocarbon::building
