// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! \brief Reads a mesh of Gmsh (MSH 2 to 2.2 and 4.1, text or binary): its triangles and quadrangles, or where it has
//! none the boundary of the cells that fill space.
//! \throw UserError (malformed) with the line, or the byte where data is binary
PolygonSoup read_msh(std::string_view contents, const std::string& file);

bool begins_like_msh(std::string_view contents);

}  // namespace nanocarbon::mesh
