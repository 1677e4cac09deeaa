// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! \brief Reads an STL file; corners at exactly the same coordinates become one vertex, since STL has no
//! vertices.
//! \details Normals, colours and attributes are passed over (they may even be NaN). Several solids in a text
//! file are one mesh. Where a binary file's count is zero, or is wrong and the file is one of whole triangles that
//! close, the length of the file is believed instead.
//! \throw UserError (malformed)
PolygonSoup read_stl(std::string_view contents, const std::string& file);

//! Whether the contents are a text STL: they begin with "solid", and what follows is no binary STL whose
//! free-form header happens to begin so.
bool is_text_stl(std::string_view contents);

//! Whether the contents have exactly the length that a binary STL with their triangle count has.
bool has_binary_stl_size(std::string_view contents);

}  // namespace nanocarbon::mesh
