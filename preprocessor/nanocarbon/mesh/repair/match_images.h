// SPDX-License-Identifier: GPL-2.0-or-later
// Which vertices at the faces of a cell are one because they lie upon images of each other.
#pragma once

#include <span>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! Of each vertex of a mesh, those that it is one with because they are images of each other.
using Partners = std::vector<std::vector<VertexIndex>>;

//! \brief Finds boundary vertices that lie upon images of others.
//! \param mesh in free space, cut at the faces of the cell
//! \param cell that the boundary lies in the faces of
//! \param boundary vertices of the mesh
//! \param reach how far a vertex may lie from the image of another, mesh units
Partners match_images(const TriangleMesh& mesh, const Cell& cell, std::span<const VertexIndex> boundary,
                      double reach);

}  // namespace nanocarbon::mesh
