// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/core/disjoint_sets.h"
#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! One side of a face that lies on an edge.
struct EdgeUse {
  FaceIndex face;
  std::uint32_t corner;  //!< place in PolygonSoup::corners of the corner where the side begins
  bool forward;          //!< whether the side runs from the edge's lower vertex to its higher one
};

//! The edges of a mesh, each once, sorted by (low, high), with the faces at each of them. An edge is at a
//! boundary with one use, inner with two, non-manifold with more. Sides from a vertex to itself are not edges.
struct EdgeTable {
  std::vector<VertexIndex> low, high;
  std::vector<std::uint32_t> offsets = {
      0};  //!< size edges + 1; uses of edge i are [offsets[i], offsets[i + 1])
  std::vector<EdgeUse> uses;

  std::size_t size() const { return low.size(); }
  std::span<const EdgeUse> uses_of(std::size_t edge) const {
    return {uses.data() + offsets[edge], uses.data() + offsets[edge + 1]};
  }
};

//! Linear in corners while valences are bounded.
EdgeTable edge_table(const PolygonSoup& soup);

//! \brief Which sides of the faces belong together across the edges with two faces.
//! \details Number 2 f is face f as wound, 2 f + 1 is face f turned. A component is orientable when no face's
//! two numbers are in one set.
DisjointSets face_sides(std::size_t faces, const EdgeTable& edges);

//! The place in PolygonSoup::corners that follows another one around its face.
inline std::uint32_t next_corner(const PolygonSoup& soup, FaceIndex face, std::uint32_t corner) {
  return corner + 1 == soup.offsets[face + 1] ? soup.offsets[face] : corner + 1;
}

}  // namespace nanocarbon::mesh
