// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

struct SeparatedSheets {
  std::size_t edges = 0;     //!< with four faces or more, of two sheets or more
  std::size_t vertices = 0;  //!< at which fans of faces met
};

//! \brief Gives the sheets of a surface that meet at edges and vertices edges and vertices of their own, at the
//! same places.
//! \details At an edge with an even number of faces those belong together that have material between them,
//! which their winding tells: solids that touch come apart. Where the faces around an edge do not alternate
//! between one direction along it and the other, or their number is odd, nothing is done. Where sheets hang
//! together at both ends of such an edge, it gets a vertex in its middle.
SeparatedSheets separate_sheets(PolygonSoup& soup);

}  // namespace nanocarbon::mesh
