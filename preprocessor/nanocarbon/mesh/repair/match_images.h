// SPDX-License-Identifier: GPL-2.0-or-later
// Which vertices at the faces of a cell are one because they lie upon images of each other.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

struct ImageMatches {
  std::vector<std::vector<VertexIndex>> partners;  //!< of each vertex of the mesh, those that it is one with
  std::size_t nearly = 0;  //!< pairs that lie farther from images of each other than exactly
  double farthest = 0;     //!< of these, mesh units
};

//! \brief Finds the partners of boundary vertices.
//! \details Those within the reach are taken in directions alone in whose faces a vertex lies exactly on no image, the
//! nearest first. What an edge of the mesh joins is not one then, however short the edge: near an edge of the cell two
//! vertices of a small triangle may both be near an image of the third.
//! \param mesh in free space, cut at the faces of the cell
//! \param cell that the boundary lies in the faces of
//! \param boundary vertices of the mesh
//! \param exactly,reach how far a vertex may lie from an image of another, in any case and where it has none so near
ImageMatches match_images(const TriangleMesh& mesh, const Cell& cell, std::span<const VertexIndex> boundary,
                          double exactly, double reach);

}  // namespace nanocarbon::mesh
