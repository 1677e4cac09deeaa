// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! A mesh whose overlapping components have become one.
struct United {
  TriangleMesh mesh;
  std::size_t overlapping = 0;  //!< components of the mesh that overlapped others
  std::size_t unions = 0;       //!< what they have become
};

//! \brief Boolean union of components that cross (also where they have vertices or edges at the same places) or touch each
//! other in faces; others stay as they are, first.
//! \details Each component counts as a solid, also inside others that it crosses.
//! \throw UserError (unsuitable) naming the place, where one of those components is not closed, has no two sides or
//! crosses itself, or where the union is not a 2-manifold; (usage) as union_of_solids()
//! \pre manifold and consistently wound, as repair_solids() leaves a mesh
United unite(const TriangleMesh& mesh);

//! One sentence for people, beginning with "united".
std::string describe(const United& united);

}  // namespace nanocarbon::mesh
