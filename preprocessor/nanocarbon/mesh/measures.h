// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "nanocarbon/core/vec3.h"
#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! An axis-aligned box. Empty (low above high) until something is put in.
struct BoundingBox {
  Vec3 low = Vec3::Constant(1e300);
  Vec3 high = Vec3::Constant(-1e300);

  void include(const Vec3& point);
  bool empty() const { return low.x() > high.x(); }
  Vec3 extent() const { return empty() ? Vec3(Vec3::Zero()) : Vec3(high - low); }
  double longest_side() const { return extent().maxCoeff(); }
  double diagonal() const { return extent().norm(); }
};

//! Whether two boxes touch or overlap.
inline bool overlap(const BoundingBox& a, const BoundingBox& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

//! Whether a box and the segment from p to q may meet; never false where they do.
bool meets_segment(const BoundingBox& box, const Vec3& p, const Vec3& q);

BoundingBox bounding_box(std::span<const Vec3> points);

//! Lengths of edges, each edge once. Mesh units.
struct EdgeLengths {
  std::size_t edges = 0;
  double min = 0.0;
  double mean = 0.0;
  double max = 0.0;
  double standard_deviation = 0.0;

  //! Standard deviation over mean.
  double coefficient_of_variation() const { return mean > 0.0 ? standard_deviation / mean : 0.0; }
};

EdgeLengths edge_lengths(std::span<const Vec3> points, const EdgeTable& edges, const Space& space = {});
EdgeLengths edge_lengths(const TriangleMesh& mesh);

//! The triangle's normal, as long as twice its area.
Vec3 area_normal(const Vec3& a, const Vec3& b, const Vec3& c);

//! Twice the area vector of a polygon, flat or not (Newell): the normal of the plane that fits it best.
Vec3 newell_normal(std::span<const Vec3> points, std::span<const VertexIndex> corners);

//! Whether a face is no more than a line: its height is below 1e-10 of its longest side, which the rounding
//! of coordinates can make or unmake.
bool has_no_area(std::span<const Vec3> points, std::span<const VertexIndex> corners);

//! Area of all triangles, square mesh units.
double area(const TriangleMesh& mesh);

//! Volume that a closed mesh encloses, cubic mesh units; negative where it is wound inside-out. Meaningless
//! for open meshes.
double signed_volume(const TriangleMesh& mesh);
double signed_volume(const PolygonSoup& soup);

}  // namespace nanocarbon::mesh
