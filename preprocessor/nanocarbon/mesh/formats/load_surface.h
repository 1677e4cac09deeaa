// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "nanocarbon/mesh/diagnosis.h"
#include "nanocarbon/mesh/formats/cell_request.h"
#include "nanocarbon/mesh/polygon_soup.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! A surface that is fit for use: a 2-manifold, closed or with boundary, of one or more components that do
//! not intersect (they may touch in vertices and edges), consistently wound (closed ones outward), every
//! triangle with three vertices and an area.
struct LoadedSurface {
  TriangleMesh mesh;
  std::vector<std::string> repairs;   //!< what was done to the file's contents to get there
  std::vector<std::string> warnings;  //!< what is doubtful and stays
  MeshDiagnosis diagnosis;  //!< of the mesh before it was sewn in its cell, if it has one; but for where
                            //!< faces intersect, which is told of the mesh in its cell
  std::size_t vertices_read = 0;  //!< of the file as it is
  std::size_t faces_read = 0;
  std::optional<Cell> cell = {};  //!< that the request or the file says the mesh is in
  std::string unit = {};          //!< of the mesh's lengths, where the file has one
};

struct LoadOptions {
  bool repair = true;        //!< false: a mesh that needs repairs is refused, with what they are
  double close_holes = 0.0;  //!< radius below which boundary loops are closed, mesh units
  CellRequest cell = {};     //!< the periodic cell that the surface is in
  FieldRequest field =
      {};  //!< the surface, where the file has a scalar field; periodic as the cell is asked to be
};

//! \brief Reads a mesh file and repairs what can be mended; what cannot is in the diagnosis, and the mesh is
//! then not fit for use. It is not sewn in its cell.
//! \throw UserError (unreadable, malformed) as read_mesh(), (usage) as requested_cell()
LoadedSurface examine_surface(const std::filesystem::path& path, const CellRequest& cell = {});
//! The same for what was read from a file, perhaps with something done to it; the soup's notes are told first.
LoadedSurface examine_surface(PolygonSoup soup, const std::filesystem::path& path,
                              const CellRequest& cell = {}, double close_holes = 0.0);

//! \brief The same, for use: sewn in its cell, if it has one.
//! \throw UserError also (unsuitable) with every reason against it, or as in_cell()
LoadedSurface load_surface(const std::filesystem::path& path, const LoadOptions& options = {});
LoadedSurface load_surface(PolygonSoup soup, const std::filesystem::path& path,
                           const LoadOptions& options = {});

}  // namespace nanocarbon::mesh
