// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/shapes/eisenstein.h"

namespace nanocarbon::shapes {

//! A triangle cut out of the triangular lattice, counter-clockwise, its corners on lattice points.
struct LatticePiece {
  std::array<VertexIndex, 3> corner;  //!< names of its corners, shared with the pieces beside it
  std::array<Eisenstein, 3> at;       //!< where they are in the lattice
};

//! Where a vertex of a lattice surface came from.
struct LatticePlace {
  std::size_t piece;
  Eisenstein at;  //!< in that piece's lattice, in or on the piece
};

//! The small triangles of a closed surface glued together from pieces of the lattice.
struct LatticeSurface {
  std::vector<Triangle> triangles;
  std::vector<LatticePlace> vertices;  //!< corners first, by their names
};

//! \brief Glues pieces of the triangular lattice together at their edges and collects the small
//! triangles.
//! \details Small triangles that cross an edge are joined across it. The valence of a corner is the sum of
//! the pieces' angles there over 60 degrees; all other vertices have valence 6. In whole numbers
//! throughout. Linear in the triangles (times the logarithm of the number of vertices).
//! \pre the pieces form a closed oriented surface: every edge is in two pieces, in opposite
//! directions and of the same lattice vector up to a turn by a multiple of 60 degrees; corners are named 0,
//! 1, ... without gaps
LatticeSurface glue(std::span<const LatticePiece> pieces);

//! Barycentric weights of a lattice point at the corners of a piece.
std::array<double, 3> barycentric(const LatticePiece& piece, Eisenstein at);

}  // namespace nanocarbon::shapes
