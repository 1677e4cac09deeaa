// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! \brief Closes boundary loops that are smaller than a radius with triangles.
//! \details The radius of a loop is twice the area that it spans over its length: that of a circle, and half the
//! width of a rectangle of any length or more. In a cell a loop that goes round it is none. The outer boundary of a sheet is closed as well where it is so small.
//! \param radius mesh units
//! \return how many were closed
//! \pre manifold and consistently wound
std::size_t close_holes(TriangleMesh& mesh, double radius);

//! The radii of all boundary loops of a mesh in free space, in that sense.
//! \pre manifold and consistently wound
std::vector<double> boundary_radii(const TriangleMesh& mesh);

}  // namespace nanocarbon::mesh
