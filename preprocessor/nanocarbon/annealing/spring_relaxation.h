// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>
#include <vector>

#include "nanocarbon/annealing/fixed_bond_model.h"
#include "nanocarbon/annealing/surface_tether.h"

namespace nanocarbon::annealing {

//! \brief Brings badly scaled bonds into REBO2's range: springs along bonds and angles, steric terms and a stiff
//! tether to the surface.
//! \param model its graph is used, its planes are renewed
//! \param iterations at most
void relax_by_springs(FixedBondModel& model, const TetherSurface& surface, std::vector<Vec3>& positions,
                      int iterations);

//! \brief The same of some atoms and of what is a few bonds away from them, while the rest is held.
//! \param model with planes of all atoms
void relax_by_springs_around(FixedBondModel& model, const TetherSurface& surface,
                             std::vector<Vec3>& positions, std::span<const AtomIndex> atoms, int iterations);

}  // namespace nanocarbon::annealing
