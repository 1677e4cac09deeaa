// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "nanocarbon/mesh/grids/grid_surface.h"

namespace nanocarbon::mesh {

//! Nodes of an element of Gmsh by its type's number; nothing for types that are not known.
std::optional<std::size_t> msh_nodes(std::uint64_t type);

//! \brief Adds an element to a surface: triangles, quadrangles and cells that fill space, of higher orders their corners;
//! points and lines are skipped.
//! \pre msh_nodes(type) is the number of nodes
void add_msh_element(GridSurface& surface, std::uint64_t type, std::span<const VertexIndex> nodes);

}  // namespace nanocarbon::mesh
