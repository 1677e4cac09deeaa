// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/shapes/implicit_surface.h"

namespace nanocarbon::shapes {

//! \brief The surface of an implicit shape as a closed 2-manifold, its triangles about equilateral.
//! \details Marching tetrahedra on the body-centred cubic lattice. Lattice points close to the surface are
//! moved onto it first, as in F. Labelle and J. R. Shewchuk, "Isosurface stuffing" (2007), so that no slivers
//! come out; should that pinch the surface somewhere, it is done again without (plain marching tetrahedra
//! cannot). Vertices are then evened out along the surface. Time and memory grow with the volume of the box.
//! \param low,high corners of the box; parts of the shape that reach out of it are closed off there
//! \param edge about the length of the mesh's edges
//! \throw UserError (usage) where the lattice would have more than 100 million points, or the shape is not
//! met
TriangleMesh polygonise(const ImplicitShape& shape, const Vec3& low, const Vec3& high, double edge);

}  // namespace nanocarbon::shapes
