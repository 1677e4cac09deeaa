// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "nanocarbon/annealing/annealing_level.h"
#include "nanocarbon/building/annealed_options.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::building {

//! A start with a quarter of the atoms, or a quarter of that.
struct CoarseStart {
  std::optional<annealing::AnnealingLevel> level;  //!< annealed; nothing where it is of no use
  bool annealed = false;                           //!< it was worth annealing
  bool hopeless = false;  //!< annealing lost so much of the shape that other seeds will fail as well
};

//! \brief Relaxes a coarse start and anneals it, unless it is of no use.
//! \details Of no use are those far from the surface, those that leave out or lose parts of the shape, those
//! that overstretch a bond, and at a sixteenth of the atoms those bent so sharply that annealing takes too
//! long.
//! \param level unrelaxed, on the surface
//! \param surface Angstrom at the scale of the level
//! \param atoms that the level should have
//! \param refinements quarterings, from 1
//! \param seed of the annealing
CoarseStart anneal_coarse_start(annealing::AnnealingLevel level, const TriangleMesh& surface,
                                std::size_t atoms, int refinements, const AnnealOptions& options,
                                std::uint64_t seed);

//! All starts of a coarse level, and what was done for them.
struct CoarseStarts {
  std::vector<annealing::AnnealingLevel> levels;  //!< annealed, of use for refining
  int tried = 0;                                  //!< seeds
  int annealed = 0;
  bool widened = false;  //!< thin parts of the surface were made wide enough for sheets at this scale
  double seconds = 0;    //!< wall-clock, of remeshing
};

//! \brief Anneals starts with few atoms, to be refined: two, or four for the best quality.
//! \details On the surface at the scale of so few atoms: a coarse sheet is the stiffer one for its size, so
//! that it is held to the surface more than asked for, and thin parts are made wide enough for it where it
//! fails without. Each start has a seed of its own. Starts from too few atoms for the topology are left out,
//! as are those of no use.
//! \param surface Angstrom at full size
//! \param atoms at full size
//! \param refinements quarterings, from 1
CoarseStarts coarse_starts(const TriangleMesh& surface, std::size_t atoms, int refinements,
                           const AnnealOptions& options);

}  // namespace nanocarbon::building
