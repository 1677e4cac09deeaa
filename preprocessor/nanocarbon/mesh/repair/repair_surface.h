// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "nanocarbon/mesh/diagnosis.h"
#include "nanocarbon/mesh/polygon_soup.h"
#include "nanocarbon/mesh/repair/separate_sheets.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! A mesh after everything that can be mended without changing the shape has been.
struct RepairedSurface {
  TriangleMesh mesh;
  std::vector<std::string>
      repairs;  //!< what was done, a sentence each, with what the reader and polygons needed
  std::vector<std::string> mended;  //!< those of them that changed the mesh
  MeshDiagnosis diagnosis;          //!< of the mesh after the repairs
};

//! \brief Joins vertices at the same place, drops unused vertices, faces that repeat a vertex, second copies of
//! faces and folds, sews boundaries that nearly coincide, separates sheets that meet at edges and vertices,
//! triangulates polygons, winds faces alike, turns closed components that are inside-out and flips edges of
//! faces without area.
//! \details Never throws: what cannot be mended is in the diagnosis. Points and order are kept where
//! nothing is dropped.
//! \param close_holes radius in mesh units below which boundary loops are closed (close_holes.h)
//! \param crossing what becomes of sheets that cross at edges that they share
RepairedSurface repair_surface(PolygonSoup soup, double close_holes = 0.0,
                               CrossingSheets crossing = CrossingSheets::leave);

}  // namespace nanocarbon::mesh
