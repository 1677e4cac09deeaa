// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/shapes/implicit_surface.h"

namespace nanocarbon::shapes {

//! \brief Evens out the triangles of a mesh that lies close to an implicit surface, and puts its vertices
//! exactly there.
//! \details Each round moves every vertex to the middle of its neighbours and back onto the surface by Newton
//! steps along the gradient. Vertices on boundaries stay. Triangles stay what they are.
//! \param edge about the mesh's edge length; no Newton step is longer than half of it
void even_out(TriangleMesh& mesh, const ImplicitShape& shape, double edge, int rounds);
//! The same where the gradient is known, instead of found by differences: several times as fast.
void even_out(TriangleMesh& mesh, const ImplicitSlope& shape, double edge, int rounds);

//! One point moved onto the surface along the gradient, in a few Newton steps of at most half an edge each.
Vec3 onto_surface(const ImplicitSlope& shape, Vec3 point, double edge);

}  // namespace nanocarbon::shapes
