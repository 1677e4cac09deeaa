#pragma once

#include <cstdint>
#include <vector>

#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon {

//! \brief For each piece the outermost closed piece that encloses it, or itself.
//! \details By rays through the mesh, exactly. Meshes of more than 10,000 pieces are taken as if nothing
//! enclosed anything, to keep the time in bounds.
//! \pre pieces do not intersect
std::vector<std::uint32_t> outermost_around(const TriangleMesh& mesh, const MeshTopology& topology);

}  // namespace nanocarbon
