// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "nanocarbon/remeshing/crystal/tiling.h"

namespace nanocarbon::crystal {

//! What a run of isotropic remeshing did.
struct IsotropicResult {
  std::size_t splits = 0;
  std::size_t collapses = 0;
  std::size_t flips = 0;
};

//! \brief Brings every edge near one length: split above 4/3 of it, collapse below 4/5, Delaunay flips,
//! smoothing in the tangent plane (Botsch and Kobbelt 2004), with the vertices kept on the surface.
//! \param edge_length in the unit of the surface
IsotropicResult remesh_isotropically(Tiling& tiling, double edge_length, int rounds);

//! Merges the ends of an edge where the topology permits, no edge gets longer than `longest` and no triangle
//! is turned or folded.
//! \return whether it did
bool try_collapse(Tiling& tiling, HalfEdgeIndex h, double longest);

//! \brief Splits the longest or collapses the shortest edges until the tiling has this many vertices.
//! \return the number reached; it differs from the one asked for where no further collapse keeps the topology
std::size_t reach_vertex_count(Tiling& tiling, std::size_t vertices);

//! Moves inner vertices `rounds` times to the mean of their neighbours, in the tangent plane.
void smooth_tangentially(Tiling& tiling, int rounds);

}  // namespace nanocarbon::crystal
