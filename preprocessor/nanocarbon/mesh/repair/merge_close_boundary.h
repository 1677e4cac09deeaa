// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <functional>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! \brief Merges neighbouring vertices of the boundary that are close to each other.
//! \details Where a surface nearly goes through a node of the grid that it was made on, the boundary has vertices so near
//! each other that noise puts them in any order. Topology stays: an edge whose ends have another neighbour in common than
//! its triangle's third corner is left.
//! \param mesh 2-manifold; merged vertices are left without triangles
//! \param shorter_than edges of the boundary that are shorter are merged, mesh units
//! \param movable which vertices may be moved; one that may not keeps its place, and two of these are not merged
//! \return vertices that were merged into others
std::size_t merge_close_boundary(TriangleMesh& mesh, double shorter_than,
                                 const std::function<bool(VertexIndex)>& movable);

}  // namespace nanocarbon::mesh
