// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <functional>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! Which edges merge_close_vertices() looks at.
enum class MergedEdges {
  boundary,  //!< those of the boundary
  all        //!< also others
};

//! \brief Merges neighbouring vertices that are close to each other.
//! \details Where a surface nearly goes through a node of the grid that it was made on, vertices are so near each other that
//! noise puts them in any order. Topology stays: an edge is left whose ends have another neighbour in common than the third
//! corners of its triangles, or are both at the boundary without its being there.
//! \param mesh 2-manifold; merged vertices are left without triangles
//! \param shorter_than edges that are shorter are merged, mesh units
//! \param movable which vertices may be moved; one that may not keeps its place, and two of these are not merged
//! \return vertices that were merged into others
std::size_t merge_close_vertices(TriangleMesh& mesh, double shorter_than, MergedEdges which,
                                 const std::function<bool(VertexIndex)>& movable);

}  // namespace nanocarbon::mesh
