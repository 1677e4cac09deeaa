// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! \brief Reads what a 3MF file (core specification 1.3, with the production extension's parts) has built: each item
//! of the build where it is placed, components within components included.
//! \details Lengths stay in the file's unit, which the result names. Colours, materials, textures, slices and beam
//! lattices are passed over.
//! \throw UserError (malformed) with the part, the line and what is wrong
PolygonSoup read_3mf(std::string_view contents, const std::string& file);

//! Whether contents are a ZIP archive with the parts of a 3MF file.
bool begins_like_3mf(std::string_view contents);

}  // namespace nanocarbon::mesh
