// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! A mesh whose components do not cross themselves any more.
struct Untangled {
  TriangleMesh mesh;
  std::size_t components = 0;  //!< that crossed themselves
  std::size_t crossings = 0;   //!< pairs of faces that intersected
  std::size_t replaced = 0;    //!< faces that gave way to new ones
  //! Largest distance from the new surface to the mesh as it was, mesh units.
  double to_original = 0.0;
  //! And from the mesh to the new surface: large where a spike is gone.
  double from_original = 0.0;
};

//! \brief New triangles where a component crosses itself in a few places, as scans and remeshers leave them: a vertex
//! that was pushed through the other side, spikes that cross, folds. All other faces, genus and boundary loops stay.
//! \details Components that do not cross themselves stay as they are, those that cross others or have faces without
//! area among them.
//! \throw UserError (unsuitable) naming the place and why, where that is more than a small fault: a component that
//! passes through itself in thousands of faces, or where a new surface would have other handles, would replace more
//! than a fifth of the area, or would lie off the old one by more than a twentieth of the size and than its longest
//! edge; (usage) as mend_crossings()
//! \pre manifold and consistently wound, in free space
Untangled untangle(const TriangleMesh& mesh);

//! One sentence for people, beginning with "untangled".
std::string describe(const Untangled& untangled);

}  // namespace nanocarbon::mesh
