// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>

#include "nanocarbon/annealing/fixed_bond_rebo2.h"
#include "nanocarbon/core/bond_cutoffs.h"
#include "nanocarbon/core/thread_team.h"

namespace nanocarbon::annealing {

//! Search radius for unbonded pairs, Angstrom: beyond REBO2's cut-off of 2.0, below second neighbours
//! at 2.46.
inline constexpr double unbonded_search_radius = 2.2;

//! Whether REBO2 sees exactly the intended bond graph: bonds below 1.7 (where the cut-off begins), other pairs
//! above 2.0.
struct GeometryCheck {
  double shortest_bond = 0;                          //!< Angstrom
  double longest_bond = 0;                           //!< Angstrom
  double closest_unbonded = unbonded_search_radius;  //!< Angstrom; the search radius if no pair is closer

  bool sound() const {
    constexpr BondCutoff carbon = rebo_bond_cutoffs.carbon_carbon;
    return longest_bond < carbon.begin && closest_unbonded > carbon.end;
  }
};

GeometryCheck check_geometry(std::span<const Vec3> positions, const FixedBondGraph& graph,
                             ThreadTeam* team = nullptr);

}  // namespace nanocarbon::annealing
