// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "nanocarbon/mesh/diagnosis.h"
#include "nanocarbon/mesh/polygon_soup.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! A mesh after everything that can be mended without changing the shape has been.
struct RepairedSurface {
  TriangleMesh mesh;
  std::vector<std::string> repairs;  //!< what was done, a sentence each
  MeshDiagnosis diagnosis;           //!< of the mesh after the repairs
};

//! \brief Triangulates polygons, joins coincident vertices along seams, drops unused vertices, faces that
//! repeat a vertex and second copies of faces, winds faces alike, turns closed components that are inside-out
//! and flips edges of faces without area.
//! \details Never throws: what cannot be mended is in the diagnosis. Points and order are kept where
//! nothing is dropped.
RepairedSurface repair_surface(PolygonSoup soup);

}  // namespace nanocarbon::mesh
