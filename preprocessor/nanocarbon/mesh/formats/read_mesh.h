// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "nanocarbon/mesh/grids/field_request.h"
#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! \brief Reads a mesh file (OFF, OBJ, PLY, STL, glTF, 3MF, VTK's polygons and grids, Gmsh's MSH), or the isosurface of
//! a scalar field (cube, MRC, VTK's images); text or binary, perhaps packed by gzip. Coordinates are in double.
//! \details The contents decide on the format; the extension only where they do not. Linear in the size of
//! the file; counts that the file promises are checked against what is there and never allocated for.
//! Windows and old Mac line ends, a byte order mark and a missing last line end are accepted; the locale
//! does not matter. STL corners at the same coordinates are one vertex. Whatever is passed over is told in
//! the result's notes.
//! \throw UserError (unreadable) for a file that is missing, is no regular file, cannot be opened or is
//! above 4 GiB
//! \throw UserError (malformed) with file and line (or byte), what is wrong and what to do
//! \throw UserError (usage) for a field without a level, or a mesh with one
PolygonSoup read_mesh(const std::filesystem::path& path, const FieldRequest& field = {});

//! \brief Reads a mesh from memory.
//! \param file name for messages; its extension is the hint for the format
PolygonSoup parse_mesh(std::string_view contents, const std::string& file, const FieldRequest& field = {});

}  // namespace nanocarbon::mesh
