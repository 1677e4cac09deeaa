// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::shapes {

//! What it takes to be a 2-manifold, from the triangles alone.
struct ManifoldCheck {
  bool manifold = false;  //!< every edge in one or two triangles, oppositely wound; one fan at every vertex
  std::vector<bool> on_boundary;  //!< for each vertex
};
ManifoldCheck check_manifold(const TriangleMesh& mesh);

//! Removes vertices that are in no triangle; the others keep their order.
void drop_unused_points(TriangleMesh& mesh);

}  // namespace nanocarbon::shapes
