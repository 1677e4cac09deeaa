#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "nanocarbon/mesh/diagnosis.h"
#include "nanocarbon/mesh/polygon_soup.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon {

//! A mesh after everything that can be mended without changing the shape has been.
struct RepairedSurface {
  TriangleMesh mesh;
  std::vector<std::string> repairs;  //!< what was done, a sentence each
  MeshDiagnosis diagnosis;           //!< of the mesh after the repairs
};

//! \brief Triangulates polygons, joins coincident vertices along seams, drops unused vertices, faces that
//! repeat a vertex and second copies of faces, winds faces alike, turns closed pieces that are inside-out
//! and flips edges of faces without area.
//! \details Never throws: what cannot be mended is in the diagnosis. Points and order are kept where
//! nothing is dropped.
RepairedSurface repair_surface(PolygonSoup soup);

//! A surface that is fit for use: a 2-manifold, closed or with boundary, of one or more pieces that do not
//! intersect, consistently wound (closed ones outward), every triangle with three vertices and an area.
struct LoadedSurface {
  TriangleMesh mesh;
  std::vector<std::string> repairs;   //!< what was done to the file's contents to get there
  std::vector<std::string> warnings;  //!< what is doubtful and stays
  MeshDiagnosis diagnosis;            //!< of the mesh as it is here
};

//! \brief Reads a mesh file and repairs what can be mended.
//! \throw UserError (unreadable, malformed) as read_mesh(), or (unsuitable) with every reason against it
LoadedSurface load_surface(const std::filesystem::path& path);

}  // namespace nanocarbon
