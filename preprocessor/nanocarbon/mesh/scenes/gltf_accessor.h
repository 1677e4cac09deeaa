// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "nanocarbon/core/vec3.h"
#include "nanocarbon/mesh/scenes/gltf_buffers.h"

namespace nanocarbon::mesh {

//! \brief The positions of an accessor: floats, or integers as quantised meshes have them, normalised or not.
//! \throw UserError (malformed) naming the accessor
std::vector<Vec3> gltf_positions(GltfFile& file, std::uint64_t accessor);

//! The same for the numbers of vertices.
std::vector<std::uint64_t> gltf_indices(GltfFile& file, std::uint64_t accessor);

}  // namespace nanocarbon::mesh
