// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! Areas of the connected components of a mesh, in the order of their lowest faces. Square mesh units.
std::vector<double> component_areas(const TriangleMesh& mesh);

//! \brief Drops components with less than an area, as a segmented scan leaves them; points and faces that stay keep
//! their order.
//! \return how many were dropped
std::size_t drop_specks(TriangleMesh& mesh, double least_area);

}  // namespace nanocarbon::mesh
