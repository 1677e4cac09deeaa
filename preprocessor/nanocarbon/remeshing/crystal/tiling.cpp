// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/crystal/tiling.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "nanocarbon/core/chunks.h"

namespace nanocarbon::crystal {

Tiling tiling_of(const SurfaceGuide& guide) {
  Tiling tiling;
  tiling.guide = &guide;
  tiling.table = guide.table();
  tiling.points = guide.mesh().points;
  tiling.normals.assign(tiling.points.size(), Vec3::Zero());
  tiling.places.assign(tiling.points.size(), 0);
  for (VertexIndex v = 0; v < tiling.points.size(); ++v) {
    if (!tiling.table.vertex_alive(v)) continue;
    const HalfEdgeIndex h = tiling.table.outgoing(v);
    tiling.places[v] = tiling.table.on_boundary(v) ? h : h / 3;
    place_vertex(tiling, v, tiling.points[v]);
  }
  return tiling;
}

void place_vertex(Tiling& tiling, VertexIndex v, const Vec3& p) {
  if (tiling.is_held(v)) return;
  const SurfaceGuide& guide = *tiling.guide;
  if (tiling.table.on_boundary(v)) {
    const BoundaryFoot foot = guide.follow_boundary(p, tiling.places[v]);
    tiling.points[v] = foot.point;
    tiling.normals[v] = guide.boundary_normal(foot);
    tiling.places[v] = foot.edge;
  } else {
    const Foot foot = guide.follow(p, tiling.places[v]);
    tiling.points[v] = foot.point;
    tiling.normals[v] = guide.normal(foot);
    tiling.places[v] = foot.triangle;
  }
}

void settle_on_surface(Tiling& tiling) {
  const SurfaceGuide& guide = *tiling.guide;
  for_chunks(tiling.team, tiling.points.size(), [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<VertexIndex>(begin); v < end; ++v) {
      if (!tiling.table.vertex_alive(v) || tiling.is_held(v)) continue;
      if (tiling.table.on_boundary(v)) {
        place_vertex(tiling, v, tiling.points[v]);
        continue;
      }
      const Foot foot = guide.nearest(tiling.points[v], tiling.normals[v], tiling.places[v]);
      tiling.points[v] = foot.point;
      tiling.normals[v] = guide.normal(foot);
      tiling.places[v] = foot.triangle;
    }
  });
}

void compact(Tiling& tiling) {
  const std::vector<VertexIndex> former = tiling.table.compact();
  for (std::size_t k = 0; k < former.size(); ++k) {
    tiling.points[k] = tiling.points[former[k]];
    tiling.normals[k] = tiling.normals[former[k]];
    tiling.places[k] = tiling.places[former[k]];
    if (!tiling.held.empty()) tiling.held[k] = tiling.held[former[k]];
  }
  if (!tiling.held.empty()) tiling.held.resize(former.size());
  tiling.points.resize(former.size());
  tiling.normals.resize(former.size());
  tiling.places.resize(former.size());
}

void put_in_order(Tiling& tiling) {
  const auto count = static_cast<VertexIndex>(tiling.table.vertices());
  std::vector<VertexIndex> order, place(count, free_vertex);
  order.reserve(count);
  const auto reach = [&](VertexIndex v) {
    if (place[v] != free_vertex) return;
    place[v] = static_cast<VertexIndex>(order.size());
    order.push_back(v);
  };
  for (VertexIndex start = 0; start < count; ++start) {
    std::size_t next = order.size();
    for (reach(start); next < order.size(); ++next) tiling.table.for_neighbours(order[next], reach);
  }
  // Triangles by their first vertex.
  std::vector<Triangle> triangles = tiling.table.triangles();
  for (Triangle& t : triangles)
    for (VertexIndex& v : t) v = place[v];
  std::vector<std::uint32_t> begin(count + 1, 0);
  const auto first = [](const Triangle& t) { return std::min({t[0], t[1], t[2]}); };
  for (const Triangle& t : triangles) ++begin[first(t) + 1];
  for (VertexIndex v = 0; v < count; ++v) begin[v + 1] += begin[v];
  TriangleMesh mesh;
  mesh.triangles.resize(triangles.size());
  for (const Triangle& t : triangles) mesh.triangles[begin[first(t)]++] = t;
  mesh.points.resize(count);
  tiling.table = CornerTable(mesh);
  const auto permute = [&](auto& values) {
    auto former = values;
    for (VertexIndex v = 0; v < count; ++v) values[v] = former[order[v]];
  };
  permute(tiling.points);
  permute(tiling.normals);
  permute(tiling.places);
}

TriangleMesh to_mesh(const Tiling& tiling) {
  Tiling dense = tiling;
  compact(dense);
  return {std::move(dense.points), dense.table.triangles(), tiling.space()};
}

double mean_edge_length(const Tiling& tiling) {
  double sum = 0;
  std::size_t edges = 0;
  for (HalfEdgeIndex h = 0; h < tiling.table.half_edges(); ++h) {
    if (!tiling.table.is_edge(h)) continue;
    sum += tiling.between(tiling.table.origin(h), tiling.table.target(h)).norm();
    ++edges;
  }
  return edges ? sum / static_cast<double>(edges) : 0;
}

}  // namespace nanocarbon::crystal
