// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! \brief Removes triangles without area, as CAD programs write them where edges do not match, by flipping
//! edges.
//! \details A triangle whose middle vertex lies on its longest side has that side flipped: the neighbour is
//! cut in two at the vertex, and the shape stays the same. Where the neighbour has no area either, only
//! flips that shorten the edge are made, so that it ends. Triangles with two vertices at one place cannot
//! be removed like this and stay.
//! \return how many edges were flipped
//! \pre manifold and consistently wound
std::size_t flip_slivers(TriangleMesh& mesh);

}  // namespace nanocarbon::mesh
