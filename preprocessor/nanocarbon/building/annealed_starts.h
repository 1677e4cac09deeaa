// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "nanocarbon/annealing/annealing_level.h"
#include "nanocarbon/building/annealed_options.h"
#include "nanocarbon/building/start_choice.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::building {

//! A molecule annealed at full size under the tether, and what it is once it is let go.
struct AnnealedStart {
  annealing::AnnealingLevel level;
  Released released = {};
  int refinements = 0;             //!< times that it was refined
  Mat3 strain = Mat3::Identity();  //!< of a periodic cell, and the surface in it, that it was annealed in
  Mat3 deformation = Mat3::Identity();  //!< of that cell, further, once it is let go
};

//! \brief Refines a coarse molecule to full size and anneals it shortly on the way.
//! \param level annealed, coarse
//! \param refinements that lead to full size
//! \param surface Angstrom at full size
//! \param atoms at full size
//! \param unannealed eV for each atom, of a start at full size by dual relaxation alone
//! \return nothing where a bond does not hold, or where relaxation alone leaves more than `unannealed`, so that
//! there is nothing to gain
std::optional<AnnealedStart> refined_start(annealing::AnnealingLevel level, int refinements,
                                           const TriangleMesh& surface, std::size_t atoms, double unannealed,
                                           const AnnealOptions& options);

//! \brief Anneals a relaxed start at full size.
//! \param alone no refined start has come about
AnnealedStart annealed_at_full_size(annealing::AnnealingLevel level, const TriangleMesh& surface,
                                    std::size_t atoms, bool alone, const AnnealOptions& options);

//! The best of all starts.
struct BestStart {
  AnnealedStart start;
  double seconds = 0;  //!< wall-clock, of remeshing
};

//! \brief Anneals starts refined from coarser levels, and one at full size unless it cannot win, and takes the
//! best.
//! \details Smooth shapes gain much by refining: what lies far apart comes to order. Shapes with thin parts do
//! not show them at a quarter of the atoms.
//! \param direct the start at full size, relaxed
BestStart best_start(annealing::AnnealingLevel direct, const TriangleMesh& surface, std::size_t atoms,
                     const AnnealOptions& options);

}  // namespace nanocarbon::building
