// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

struct SeparatedSheets {
  std::size_t edges = 0;     //!< with four faces or more, of two sheets or more
  std::size_t vertices = 0;  //!< at which fans of faces met
};

//! What becomes of edges around which four faces do not alternate between one direction and the other: two sheets cross
//! there.
enum class CrossingSheets {
  leave,  //!< the edge is not manifold
  go_on,  //!< each sheet goes on behind the other, so that both are whole, and cross
};

//! \brief Gives the sheets of a surface that meet at edges and vertices edges and vertices of their own, at the
//! same places.
//! \details At an edge with an even number of faces those belong together that have material between them,
//! which their winding tells: solids that touch come apart. Where the faces around an edge do not alternate
//! between one direction along it and the other, nothing is done, unless they are four and crossing sheets are to go on;
//! nor where their number is odd. Where sheets hang
//! together at both ends of such an edge, it gets a vertex in its middle.
SeparatedSheets separate_sheets(PolygonSoup& soup, CrossingSheets crossing = CrossingSheets::leave);

}  // namespace nanocarbon::mesh
