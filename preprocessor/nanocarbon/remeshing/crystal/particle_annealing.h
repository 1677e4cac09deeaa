// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "nanocarbon/remeshing/crystal/tiling.h"

namespace nanocarbon::crystal {

//! How a tiling's vertices are annealed. Energies in units of half a bond's depth, lengths in units of the
//! spacing.
struct AnnealingSchedule {
  std::size_t steps = 3000;
  double hot = 2.0;   //!< temperature at the start; the flat crystal melts near 2.5
  double cold = 0.2;  //!< at the end
  std::uint64_t seed = 1;
  //! Called now and then with the share of the steps that are done; may throw, to end it; may be empty.
  std::function<void(double share)> progress = {};
};

//! What an annealing did.
struct AnnealingResult {
  std::size_t flips = 0;     //!< Delaunay flips
  std::size_t set_back = 0;  //!< moves taken back because they turned a triangle
};

//! \brief Anneals the vertices as particles on the surface tied to their neighbours in the mesh by
//! 2 (a/r)^12 - 4 (a/r)^6.
//! \details Langevin dynamics in the tangent planes, cooled linearly; every few steps the particles go back
//! to the surface and the mesh back to Delaunay. Cooled slowly past freezing, a crystal with few defects
//! forms. A pure repulsion would do the same on a plane, but gains energy by folding the mesh over itself:
//! area for the same particles. No move may turn a triangle against the surface. Linear in vertices; the same
//! for the same seed.
//! \param spacing a, in the unit of the surface
AnnealingResult anneal_particles(Tiling& tiling, double spacing, const AnnealingSchedule& schedule);

//! \brief Evens edge lengths at fixed connectivity: descent on the springs' energy sum of (length / spacing -
//! 1)^2.
//! \return the largest force left, relative to the springs' constant times the spacing
double even_edges(Tiling& tiling, double spacing, std::size_t steps);

}  // namespace nanocarbon::crystal
