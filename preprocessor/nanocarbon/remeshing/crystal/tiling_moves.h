// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "nanocarbon/remeshing/crystal/tiling.h"

namespace nanocarbon::crystal {

//! \brief Moves a vertex by this share of the way to the mean of its neighbours (a boundary vertex: of those
//! on the boundary), in the tangent plane, unless that would turn or fold triangles.
//! \return whether it moved
bool relax_vertex(Tiling& tiling, VertexIndex v, double share);
//! Splits an edge at its midpoint, moved to the surface, unless that would turn a triangle or
//! change the valence of a held vertex.
//! \return whether it did
bool split_edge(Tiling& tiling, HalfEdgeIndex h);
//! Splits every triangle in four. New inner vertices have valence 6, others keep theirs.
void split_in_four(Tiling& tiling);

//! \brief Mends turned and folded triangles by flips and by moving vertices to the middle of their
//! neighbours.
//! \return how many vertices are left with an unsound triangle
std::size_t unfold(Tiling& tiling, int rounds);

}  // namespace nanocarbon::crystal
