// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "nanocarbon/core/cell.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

struct SewnSurface {
  TriangleMesh mesh;               //!< in the cell: vertices that were images of each other are one
  std::vector<std::string> notes;  //!< what was done, for the user
};

//! \brief A mesh that was cut at the faces of a periodic cell, made whole across them.
//! \details Flat faces in both of two opposite cell faces, with which generators of solids close a mesh, are
//! dropped. Boundary vertices that lie on images of others are joined with them. Where a boundary lies along the
//! image of another, but has its vertices elsewhere, each gets the other's vertices first. What is beyond the cell as the image
//! of something in it is dropped; the mesh may be cut elsewhere than where the cell begins. Boundaries that no face of the cell
//! cut stay: holes. Edges longer than a quarter of the least width are split, so that nearest
//! images tell what is connected.
//! \param mesh in free space, mesh units: triangles with area, 2-manifold
//! \param match boundary vertices this near to images of others are the same, in mean edges
//! \throw UserError (unsuitable) where a boundary in a cell face has no partner, saying where; where the surface
//! has no two sides or is no manifold in the cell
SewnSurface sew_in_cell(const TriangleMesh& mesh, const Cell& cell, double match = 1e-3);

}  // namespace nanocarbon::mesh
