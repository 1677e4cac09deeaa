// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/vertex_stars.h"

#include <Eigen/Geometry>

namespace nanocarbon::thesis {

VertexStars vertex_stars(const Triangulation& mesh) {
  VertexStars stars;
  const std::size_t n = mesh.n_vertices();
  stars.offsets.reserve(n + 1);
  stars.offsets.push_back(0);
  stars.neighbours.reserve(2 * mesh.n_edges());
  stars.on_boundary.resize(n);
  stars.points.resize(n);
  for (std::size_t v = 0; v < n; ++v) {
    const VertexHandle handle(static_cast<int>(v));
    stars.points[v] = mesh.point(handle);
    stars.on_boundary[v] = mesh.is_boundary(handle);
    const auto turn = [&](HalfedgeHandle h) {
      return mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(h));
    };
    HalfedgeHandle first = mesh.halfedge_handle(handle);
    // A boundary vertex's own half-edge has the hole at its left: begin behind the hole.
    if (first.is_valid() && stars.on_boundary[v]) first = turn(first);
    for (HalfedgeHandle h = first; h.is_valid();) {
      stars.neighbours.push_back(static_cast<VertexIndex>(mesh.to_vertex_handle(h).idx()));
      h = turn(h);
      if (h == first) break;
    }
    stars.offsets.push_back(static_cast<std::uint32_t>(stars.neighbours.size()));
  }
  return stars;
}

void set_points(Triangulation& mesh, const VertexStars& stars) {
  for (std::size_t v = 0; v < stars.vertices(); ++v)
    mesh.set_point(VertexHandle(static_cast<int>(v)), stars.points[v]);
}

Vec3 vertex_normal(const VertexStars& stars, std::size_t vertex) {
  const auto ring = stars.of(vertex);
  const Vec3& p = stars.points[vertex];
  Vec3 normal = Vec3::Zero();
  const std::size_t n = ring.size(), faces = stars.on_boundary[vertex] ? n - (n > 0) : n;
  for (std::size_t k = 0; k < faces; ++k)
    normal += (stars.points[ring[k]] - p).cross(stars.points[ring[k + 1 == n ? 0 : k + 1]] - p);
  const double length = normal.norm();
  return length > 0.0 ? Vec3(normal / length) : Vec3::Zero();
}

std::span<const VertexIndex> RingSearch::search(std::span<const VertexIndex> start, unsigned rings) {
  base_ += found_.size();
  found_.clear();
  begin_.assign(1, 0);
  const auto visit = [&](VertexIndex v) {
    if (stamp_[v] > base_) return;
    found_.push_back(v);
    stamp_[v] = base_ + found_.size();
  };
  for (const VertexIndex v : start) visit(v);
  begin_.push_back(found_.size());
  for (unsigned r = 0; r < rings; ++r) {
    const std::size_t end = found_.size();
    for (std::size_t k = begin_[r]; k < end; ++k)
      for (const VertexIndex v : stars_.of(found_[k])) visit(v);
    begin_.push_back(found_.size());
  }
  return found_;
}

}  // namespace nanocarbon::thesis
