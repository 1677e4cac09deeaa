// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! \brief Reads the elements vertex (x, y, z) and face (vertex_indices or vertex_index) of a PLY file, and tristrips:
//! text or binary of either byte order, properties of any type and in any order. Other elements and properties
//! are passed over; so are values at the ends of text lines that the header does not announce, where every line
//! of an element has as many.
//! \throw UserError (malformed)
PolygonSoup read_ply(std::string_view contents, const std::string& file);

}  // namespace nanocarbon::mesh
