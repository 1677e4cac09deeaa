// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "nanocarbon/annealing/annealing_level.h"
#include "nanocarbon/building/annealed_options.h"
#include "nanocarbon/remeshing/crystal/crystallise.h"

namespace nanocarbon::building {

//! The dual of a crystalline triangulation as it is, yet to be relaxed.
struct CrystalStart {
  std::optional<annealing::AnnealingLevel> level;  //!< nothing where the triangulation pinches thin parts
  double seconds = 0;                              //!< wall-clock, of remeshing
};

//! \brief Remeshes a surface with a triangle for each atom.
//! \param surface Angstrom, of the size for so many atoms
//! \param attempts seeds that remeshing tries at most
//! \throw UserError (size) where the surface's topology cannot be kept with so few triangles
CrystalStart crystal_start(const TriangleMesh& surface, std::size_t atoms, const AnnealOptions& options,
                           int attempts = crystal::CrystalOptions{}.attempts);

//! \brief The same, and with other seeds until no thin part is pinched.
//! \return always with a level
//! \throw UserError (size) as above, or where all seeds fail
CrystalStart full_size_start(const TriangleMesh& surface, std::size_t atoms, const AnnealOptions& options);

}  // namespace nanocarbon::building
