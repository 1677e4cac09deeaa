// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "nanocarbon/core/cell.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! \brief Moves a cell to where a mesh was cut at its faces, and drops what the mesh holds a second time beyond it.
//! \details Any cell of the lattice will do: one begins where the mesh does. Grids that were padded on either side, and files of
//! several cells, hold images of faces that are in the cell. Where what is beyond is no image, nothing is dropped.
//! \param mesh in free space, mesh units
//! \param cell only its origin changes
//! \param tolerance vertices this near to each other's images are the same, mesh units
//! \param near a mesh that is this much longer or shorter than the cell was cut at its faces, mesh units
//! \return faces that were dropped
std::size_t place_cell(TriangleMesh& mesh, Cell& cell, double tolerance, double near);

}  // namespace nanocarbon::mesh
