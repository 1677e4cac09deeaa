// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "nanocarbon/mesh/diagnosis.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! A surface that is fit for use: a 2-manifold, closed or with boundary, of one or more components that do
//! not intersect, consistently wound (closed ones outward), every triangle with three vertices and an area.
struct LoadedSurface {
  TriangleMesh mesh;
  std::vector<std::string> repairs;   //!< what was done to the file's contents to get there
  std::vector<std::string> warnings;  //!< what is doubtful and stays
  MeshDiagnosis diagnosis;            //!< of the mesh as it is here
};

//! \brief Reads a mesh file and repairs what can be mended.
//! \throw UserError (unreadable, malformed) as read_mesh(), or (unsuitable) with every reason against it
LoadedSurface load_surface(const std::filesystem::path& path);

}  // namespace nanocarbon::mesh
