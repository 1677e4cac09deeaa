// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "nanocarbon/building/annealed_options.h"
#include "nanocarbon/building/annealing_record.h"
#include "nanocarbon/building/final_minimum.h"
#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/potential/potential.h"

namespace nanocarbon::building {

//! What anneal() made and did.
struct AnnealResult {
  FinalMinimum minimum;
  AnnealingRecord record;
  double remeshing_seconds = 0;  //!< wall-clock
};

//! \brief The default recipe: from a surface to a molecule at a minimum of the potential.
//!
//! Makes room for sheets where parts of the surface lie too close. Remeshes it and relaxes the dual
//! (crystal_start.h). Anneals at a sixteenth and a quarter of the atoms and refines step by step, where the
//! shape still shows with so few (coarse_starts.h); anneals at full size, too, where that may be better
//! (annealed_starts.h). Takes the molecule with the least energy once it is let go of those within 1 Angstrom
//! of the surface in the mean; where there is none, at a price for distance (start_choice.h). Then minimises the
//! full potential without a tether, with hydrogen at the boundary where that is wanted (final_minimum.h).
//!
//! \param surface Angstrom; a sound oriented 2-manifold, with or without boundary
//! \param potential of the last minimisation
//! \param atoms wanted; met within one percent where the surface allows
//! \throw UserError (size) where the surface's topology or its thinnest parts ask for more atoms
AnnealResult anneal(const TriangleMesh& surface, std::size_t atoms, potential::Potential& potential,
                    const AnnealOptions& options);

}  // namespace nanocarbon::building
