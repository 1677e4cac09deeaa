// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>
#include <vector>

#include "nanocarbon/annealing/fixed_bond_rebo2.h"
#include "nanocarbon/annealing/surface_tether.h"
#include "nanocarbon/core/bond_cutoffs.h"

namespace nanocarbon::annealing {

//! What REBO2 sees as a bond, and what it does not see, Angstrom.
struct SeenBonds {
  double longest = rebo_bond_cutoffs.carbon_carbon.begin;
  double closest_unbonded = rebo_bond_cutoffs.carbon_carbon.end;
};

//! Atoms that do not lie as their bonds want them: ends of longer bonds, and of closer pairs that are not bonded.
//! Sorted.
std::vector<AtomIndex> tangled_atoms(std::span<const Vec3> positions, const FixedBondGraph& graph,
                                     ThreadTeam* team = nullptr, const SeenBonds& seen = {});

//! \brief Takes folds and knots out of a network by a barycentric embedding around the given atoms.
//! \details Every atom within `radius` bonds of them moves to the centroid of its neighbours again and again,
//! in its tangent plane, while those beyond are held: in a flat disc no crossing survives that (Tutte 1963).
//! The bonds come out too short and uneven; springs must follow.
//! \return atoms moved
std::vector<AtomIndex> unknot(std::vector<Vec3>& positions, const FixedBondGraph& graph,
                              const TetherSurface& surface, std::span<const AtomIndex> around,
                              unsigned radius);

}  // namespace nanocarbon::annealing
