// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! \brief A closed 2-manifold without self-intersections that contains all triangles of a mesh, whatever these
//! are: CGAL's 3D alpha wrap (Portaneri et al., Alpha Wrapping with an Offset, ACM Trans. Graph. 41, 2022).
//! \param alpha, offset mesh units, above zero
//! \throw UserError (usage) where this was built without CGAL
//! \pre a triangle has an area
TriangleMesh alpha_wrap(const TriangleMesh& mesh, double alpha, double offset);

}  // namespace nanocarbon::mesh
