// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! Pairs of triangles of a mesh that meet elsewhere than in the vertices or the edge they share.
struct SelfIntersections {
  std::vector<std::array<std::uint32_t, 2>> pairs;  //!< first < second, sorted
  //! In a periodic cell, of each pair: by which translation the first must be moved to meet the second, with the first
  //! corner of either where the mesh has it. Empty in free space.
  std::vector<Vec3> moved;
  bool complete = true;  //!< false where the search was given up
};

//! \brief Finds all pairs of triangles that intersect.
//! \details Exact: decided by signs that are right whatever the rounding. Touching counts; triangles without
//! area do not. O(n log n) for surfaces. Given up after a hundred thousand pairs found, or twenty million
//! and 64 for each triangle tried, which only heaps of overlapping triangles and fans of very many need. In a
//! periodic cell triangles meet the images of others, too; vertices at the same place are one there, and touching
//! is decided up to the rounding of images.
SelfIntersections self_intersections(const TriangleMesh& mesh);

//! \brief Adds where parts of a mesh pass through each other along edges that lie upon each other: no triangle of one
//! meets the inside of another there.
//! \param same_place of each vertex one that stands for all at its place, in a cell that of images too
void add_crossings_in_edges(const TriangleMesh& mesh, std::span<const VertexIndex> same_place,
                            SelfIntersections& found);

//! \brief Pairs of triangles of a mesh in free space that pass through each other: both of the above. Parts that touch in
//! vertices and edges at the same places do not.
//! \param same_place of each vertex one that stands for all at its place
SelfIntersections crossings(const TriangleMesh& mesh, std::span<const VertexIndex> same_place);

//! Of each vertex of a mesh in a cell the first at its place or an image of it, up to rounding.
std::vector<VertexIndex> first_at_place(const TriangleMesh& mesh);

}  // namespace nanocarbon::mesh
