// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! \brief For each component the outermost closed component that encloses it, or itself.
//! \details By rays through the mesh, exactly. Meshes of more than 10,000 components are taken as if nothing
//! enclosed anything, to keep the time in bounds.
//! \pre components do not intersect
std::vector<std::uint32_t> outermost_around(const TriangleMesh& mesh, const MeshTopology& topology);

}  // namespace nanocarbon::mesh
