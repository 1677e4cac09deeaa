// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "nanocarbon/remeshing/crystal/tiling.h"

namespace nanocarbon::crystal {

//! Below this a triangle counts as turned against the surface.
inline constexpr double turned_below = 0.2;
//! Below this cosine between the normals of two neighbouring triangles the edge between them counts as
//! folded.
inline constexpr double creased_below = -0.8;

//! A vertex apart from its mesh: where it is, the surface's normal there, its triangle on the guide.
struct Corner {
  Vec3 point;
  Vec3 normal;
  std::uint32_t triangle;
};
Corner corner(const Tiling& tiling, VertexIndex v);

//! \brief Cosine between a triangle's normal and the surface's, the mean of the surface's at its corners.
//! \details Where the corners' normals nearly cancel (the triangle lies across a rim sharper than itself, and
//! may rightly stand square to either side) it is the cosine with the normal at the centroid, with 0.5
//! forgiven. -1 for a triangle without area.
double facing(const SurfaceGuide& guide, const Corner& a, const Corner& b, const Corner& c);
double facing(const Tiling& tiling, VertexIndex a, VertexIndex b, VertexIndex c);

//! Unit normal of a triangle, zero for one without area.
Vec3 unit_normal(const Space& space, const Vec3& a, const Vec3& b, const Vec3& c);

//! How far the triangles around a vertex are from being turned or folded; negative where one is.
double soundness_around(const Tiling& tiling, VertexIndex v);

//! Vertices with an unsound triangle around them that are not held, rising.
std::vector<VertexIndex> unsound_vertices(const Tiling& tiling);

//! Whether flipping an edge makes no double edge, neither turns nor folds triangles, and changes no held vertex.
bool flip_is_sound(const Tiling& tiling, HalfEdgeIndex h);

//! Whether collapsing an edge to the point of its target turns or folds no triangle, or makes nothing worse
//! there than `before`, the lesser soundness around its ends.
bool collapse_is_sound(const Tiling& tiling, HalfEdgeIndex h, double before);

}  // namespace nanocarbon::crystal
