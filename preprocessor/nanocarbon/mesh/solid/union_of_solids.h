// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! \brief The surface of what solids fill together: boolean union by CGAL's corefinement, computed exactly and
//! rounded to doubles at the end.
//! \return nothing where it is not a 2-manifold, as where solids touch in an edge only
//! \throw UserError (usage) where this was built without CGAL
//! \pre each is a closed 2-manifold that does not cross itself, wound outward
std::optional<TriangleMesh> union_of_solids(const std::vector<TriangleMesh>& solids);

}  // namespace nanocarbon::mesh
