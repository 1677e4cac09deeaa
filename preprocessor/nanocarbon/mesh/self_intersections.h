// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! Pairs of triangles of a mesh that meet elsewhere than in the vertices or the edge they share.
struct SelfIntersections {
  std::vector<std::array<std::uint32_t, 2>> pairs;  //!< first < second, sorted
  bool complete = true;                             //!< false where the search was given up
};

//! \brief Finds all pairs of triangles that intersect.
//! \details Exact: decided by signs that are right whatever the rounding. Touching counts; triangles without
//! area do not. O(n log n) for surfaces. Given up after a hundred thousand pairs found, or twenty million
//! and 64 for each triangle tried, which only heaps of overlapping triangles and fans of very many need. In a
//! periodic cell triangles meet the images of others, too; vertices at the same place are one there, and touching
//! is decided up to the rounding of images.
SelfIntersections self_intersections(const TriangleMesh& mesh);

}  // namespace nanocarbon::mesh
