// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! Corners of a polygon above which it is not triangulated; the time may grow with their square.
constexpr std::size_t most_corners = 10000;

//! Whether there is a face, and none has more than most_corners corners.
bool can_be_triangulated(const PolygonSoup& soup);

//! What triangulate did.
struct Triangulated {
  TriangleMesh mesh;
  std::size_t polygons = 0;       //!< faces with more than three corners
  std::size_t centres_added = 0;  //!< polygons that needed a new vertex in the middle to stay manifold
};

//! \brief Cuts every polygon into triangles with the same winding; triangles stay as they are, in order.
//! \details Ears are cut off the polygon's projection along its Newell normal, the best shaped first, so
//! that concave polygons come out right. Where a new diagonal would be an edge that the mesh already has,
//! the polygon is cut into a fan around a new vertex at its centre instead.
//! A face may pass through a vertex twice, as one does that goes around a hole and back along a bridge; what
//! collapses to a line there is left out.
//! \pre can_be_triangulated(soup)
Triangulated triangulate(const PolygonSoup& soup);

}  // namespace nanocarbon::mesh
