#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon {

//! Pairs of triangles of a mesh that meet elsewhere than in the vertices or the edge they share.
struct SelfIntersections {
  std::vector<std::array<std::uint32_t, 2>> pairs;  //!< first < second, sorted
  bool complete = true;                             //!< false where the search was given up
};

//! \brief Finds all pairs of triangles that intersect.
//! \details Exact: decided by signs that are right whatever the rounding. Touching counts; triangles without
//! area do not. O(n log n) for surfaces. Given up after a hundred thousand pairs found, or a thousand pairs
//! tried for each triangle on average, which only a heap of overlapping triangles needs.
SelfIntersections self_intersections(const TriangleMesh& mesh);

}  // namespace nanocarbon
