#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon {

//! Two triangles of a mesh that meet elsewhere than in the vertices or the edge they share.
using TrianglePair = std::array<std::uint32_t, 2>;

//! \brief All pairs of triangles that intersect, first < second, sorted.
//! \details Exact: decided by signs that are right whatever the rounding. Touching counts as intersecting.
//! O(n log n) for surfaces, plus what is found.
//! \param most stops after this many pairs
std::vector<TrianglePair> self_intersections(const TriangleMesh& mesh, std::size_t most = 1'000'000);

}  // namespace nanocarbon
