// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! Which points are one: for each point the first point (in order) at its place.
struct CoincidentPoints {
  std::vector<VertexIndex> representative;
  std::size_t duplicates = 0;  //!< points that are not their own representative
};

//! Points at exactly the same coordinates (0 and -0 are the same). Linear, by hashing.
CoincidentPoints coincident_points(std::span<const Vec3> points);

//! \brief Points closer than a tolerance to an earlier point that is not itself such a point.
//! \details Linear, by spatial hashing, however many points share a place.
//! \param tolerance mesh units, above zero
CoincidentPoints points_within(std::span<const Vec3> points, double tolerance);

//! \brief Points that faces' edges shorter than a tolerance connect; also through several such edges.
//! \details Those are left where an isosurface or a section passes through points that were there before.
CoincidentPoints ends_of_short_edges(const PolygonSoup& soup, double tolerance);

//! Renames every corner to its representative and drops the points that are not their own.
void join(PolygonSoup& soup, const CoincidentPoints& coincident);

//! \brief Drops the points that no corner uses; the others keep their order.
//! \return how many were dropped
std::size_t drop_unused_points(PolygonSoup& soup);
std::size_t drop_unused_points(TriangleMesh& mesh);

}  // namespace nanocarbon::mesh
