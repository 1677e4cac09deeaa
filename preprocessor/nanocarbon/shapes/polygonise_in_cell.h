// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/core/cell.h"
#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/shapes/implicit_surface.h"

namespace nanocarbon::shapes {

//! \brief The surface of an implicit shape that repeats itself in a cell, as a mesh in that cell.
//! \details Marching tetrahedra (each cell of a grid along the cell's edges cut into six, Kuhn 1960), with the
//! nodes of opposite faces taken as one: there is no seam. Vertices are then evened out along the surface. In
//! directions that are not periodic the surface ends where it meets the cell's faces.
//! \param shape below zero inside; the same at a point and its images
//! \param edge about the length of the mesh's edges; shorter where the cell is narrow
//! \throw UserError (usage) where the grid would have more than 50 million points, or the shape is not met
//! \param slope the shape with its gradient, if that is known: it is faster then
TriangleMesh polygonise_in_cell(const ImplicitShape& shape, const Cell& cell, double edge,
                                const ImplicitSlope& slope = {});

//! \brief The same before vertices are evened out: how the surface hangs together, as a grid of these steps shows it.
//! \throw UserError as polygonise_in_cell()
TriangleMesh marched_in_cell(const ImplicitShape& shape, const Cell& cell, double edge);

}  // namespace nanocarbon::shapes
