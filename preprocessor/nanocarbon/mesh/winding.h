// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! \brief Winds the faces of each orientable component alike, turning the fewer ones.
//! \return how many faces were turned
std::size_t wind_alike(TriangleMesh& mesh, const MeshTopology& topology, const EdgeTable& edges);

//! \brief Turns closed components that are inside-out: outermost components with a negative volume, each with
//! all that it encloses. A component within another keeps its winding relative to it: opposite, as the wall
//! of a cavity, or alike, as a shell of its own.
//! \return how many components were turned
//! \pre consistently wound and manifold
std::size_t turn_outside(TriangleMesh& mesh, const MeshTopology& topology);

}  // namespace nanocarbon::mesh
