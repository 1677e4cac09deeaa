// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <variant>

#include "nanocarbon/mesh/grids/scalar_field.h"
#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! What a file that can hold either has: a surface, or a field whose surface is yet to be made.
using GridContents = std::variant<PolygonSoup, ScalarField>;

}  // namespace nanocarbon::mesh
