// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/shapes/implicit_surface.h"

namespace nanocarbon::shapes {

//! \brief The part of a mesh inside a shape (where it is below zero), with a smooth boundary where it was
//! cut.
//! \details Vertices close to the cut are moved onto it along their edges, the triangles that cross it are
//! split there.
TriangleMesh clip_mesh(const TriangleMesh& mesh, const ImplicitShape& keep);

//! Keeps the largest connected component (the first one, of several as large).
TriangleMesh largest_component(const TriangleMesh& mesh);

}  // namespace nanocarbon::shapes
