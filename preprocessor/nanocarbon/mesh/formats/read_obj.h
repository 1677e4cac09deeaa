// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! \brief Reads the polygons of a Wavefront OBJ file: lines v and f, with v/vt/vn corners, negative
//! (relative) numbers and continued lines.
//! \details Texture coordinates, normals, groups, materials, lines, points and free-form geometry are
//! passed over.
//! \throw UserError (malformed)
PolygonSoup read_obj(std::string_view text, const std::string& file);

}  // namespace nanocarbon::mesh
