// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "nanocarbon/mesh/polygon_soup.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! Solids that may overlap, for their union.
struct RepairedSolids {
  TriangleMesh mesh;                 //!< manifold and consistently wound, if it is so at all
  std::vector<std::string> repairs;  //!< what was done, a sentence each
  bool manifold = false;
};

//! \brief Repairs solids without joining them to each other where they have vertices, edges or faces at the same
//! places.
//! \details Pieces that share no vertices in the file are repaired each for itself, where all of them are closed then, and
//! so are, in formats that know no shared vertices, solids that the file lists one after the other. Otherwise all are
//! repaired together, and at edges with four faces each of two surfaces that cross goes on behind the other.
//! \param close_holes as in repair_surface()
RepairedSolids repair_solids(const PolygonSoup& soup, double close_holes = 0.0);

}  // namespace nanocarbon::mesh
