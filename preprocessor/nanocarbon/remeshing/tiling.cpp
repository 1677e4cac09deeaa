#include "nanocarbon/remeshing/tiling.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "nanocarbon/remeshing/soundness.h"

namespace nanocarbon {

Tiling tiling_of(const SurfaceGuide& guide) {
  Tiling tiling;
  tiling.guide = &guide;
  tiling.table = guide.table();
  tiling.points = guide.mesh().points;
  tiling.normals.assign(tiling.points.size(), Vec3::Zero());
  tiling.places.assign(tiling.points.size(), 0);
  for (VertexIndex v = 0; v < tiling.points.size(); ++v) {
    if (!tiling.table.vertex_alive(v)) continue;
    const HalfEdge h = tiling.table.outgoing(v);
    tiling.places[v] = tiling.table.on_border(v) ? h : h / 3;
    place_vertex(tiling, v, tiling.points[v]);
  }
  return tiling;
}

void place_vertex(Tiling& tiling, VertexIndex v, const Vec3& p) {
  const SurfaceGuide& guide = *tiling.guide;
  if (tiling.table.on_border(v)) {
    const BorderFoot foot = guide.follow_border(p, tiling.places[v]);
    tiling.points[v] = foot.point;
    tiling.normals[v] = guide.border_normal(foot);
    tiling.places[v] = foot.edge;
  } else {
    const Foot foot = guide.follow(p, tiling.places[v]);
    tiling.points[v] = foot.point;
    tiling.normals[v] = guide.normal(foot);
    tiling.places[v] = foot.triangle;
  }
}

bool relax_vertex(Tiling& tiling, VertexIndex v, double share) {
  const CornerTable& table = tiling.table;
  Vec3 mean = Vec3::Zero();
  int count = 0;
  const bool border = table.on_border(v);
  table.for_neighbours(v, [&](VertexIndex u) {
    if (border && !table.on_border(u)) return;
    mean += tiling.points[u];
    ++count;
  });
  if (border && count != 2) return false;
  const Vec3 old_point = tiling.points[v], old_normal = tiling.normals[v];
  const std::uint32_t old_place = tiling.places[v];
  Vec3 move = share * (mean / count - old_point);
  move -= move.dot(old_normal) * old_normal;
  const double before = soundness_around(tiling, v);
  place_vertex(tiling, v, old_point + move);
  const double after = soundness_around(tiling, v);
  if (after >= 0 || after >= before) return true;
  tiling.points[v] = old_point;
  tiling.normals[v] = old_normal;
  tiling.places[v] = old_place;
  return false;
}

void settle_on_surface(Tiling& tiling) {
  const SurfaceGuide& guide = *tiling.guide;
  for (VertexIndex v = 0; v < tiling.points.size(); ++v) {
    if (!tiling.table.vertex_alive(v)) continue;
    if (tiling.table.on_border(v)) {
      place_vertex(tiling, v, tiling.points[v]);
      continue;
    }
    const Foot foot = guide.nearest(tiling.points[v], tiling.normals[v], tiling.places[v]);
    tiling.points[v] = foot.point;
    tiling.normals[v] = guide.normal(foot);
    tiling.places[v] = foot.triangle;
  }
}

namespace {

struct PlacedVertex {
  Vec3 point;
  Vec3 normal;
  std::uint32_t place;
};

//! The middle between a and b, moved to the surface or, for the edge between two border vertices, to the
//! border.
PlacedVertex between(const Tiling& tiling, VertexIndex a, VertexIndex b, bool border) {
  const SurfaceGuide& guide = *tiling.guide;
  const Vec3 middle = 0.5 * (tiling.points[a] + tiling.points[b]);
  if (border) {
    const BorderFoot one = guide.follow_border(middle, tiling.places[a]);
    const BorderFoot two = guide.follow_border(middle, tiling.places[b]);
    const BorderFoot& foot =
        (one.point - middle).squaredNorm() <= (two.point - middle).squaredNorm() ? one : two;
    return {foot.point, guide.border_normal(foot), foot.edge};
  }
  const Foot foot = guide.nearest(middle, tiling.normals[a] + tiling.normals[b], corner(tiling, a).triangle);
  return {foot.point, guide.normal(foot), foot.triangle};
}

void add_vertex(Tiling& tiling, const PlacedVertex& vertex) {
  tiling.points.push_back(vertex.point);
  tiling.normals.push_back(vertex.normal);
  tiling.places.push_back(vertex.place);
}

}  // namespace

bool split_edge(Tiling& tiling, HalfEdge h) {
  const SurfaceGuide& guide = *tiling.guide;
  const CornerTable& table = tiling.table;
  const bool border = table.twin(h) == no_half_edge;
  const VertexIndex a = table.origin(h), b = table.target(h);
  const PlacedVertex middle = between(tiling, a, b, border);
  const Corner m = {middle.point, middle.normal, border ? middle.place / 3 : middle.place};
  double before = 1, after = 1;
  for (const HalfEdge side : {h, table.twin(h)}) {
    if (side == no_half_edge) continue;
    const Corner p = corner(tiling, table.origin(side)), q = corner(tiling, table.target(side));
    const Corner apex = corner(tiling, table.apex(side));
    before = std::min(before, facing(guide, p, q, apex));
    after = std::min({after, facing(guide, p, m, apex), facing(guide, m, q, apex)});
  }
  if (after < turned_below && after < before) return false;
  tiling.table.split(h);
  add_vertex(tiling, middle);
  return true;
}

void split_in_four(Tiling& tiling) {
  compact(tiling);
  const CornerTable coarse = tiling.table;
  const VertexIndex old_vertices = static_cast<VertexIndex>(coarse.vertices());
  std::vector<VertexIndex> middle(coarse.half_edges());
  struct Edge {
    VertexIndex a, b;
    bool border;
  };
  std::vector<Edge> ends;
  for (HalfEdge h = 0; h < coarse.half_edges(); ++h) {
    if (!coarse.is_edge(h)) continue;
    middle[h] = old_vertices + static_cast<VertexIndex>(ends.size());
    if (coarse.twin(h) != no_half_edge) middle[coarse.twin(h)] = middle[h];
    ends.push_back({coarse.origin(h), coarse.target(h), coarse.twin(h) == no_half_edge});
  }
  TriangleMesh fine;
  fine.points.resize(old_vertices + ends.size());
  for (HalfEdge h = 0; h < coarse.half_edges(); h += 3) {
    const VertexIndex a = coarse.origin(h), b = coarse.origin(h + 1), c = coarse.origin(h + 2);
    const VertexIndex ab = middle[h], bc = middle[h + 1], ca = middle[h + 2];
    for (const Triangle& t : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
      fine.triangles.push_back(t);
  }
  for (const Edge& edge : ends) add_vertex(tiling, between(tiling, edge.a, edge.b, edge.border));
  tiling.table = CornerTable(fine);
}

void compact(Tiling& tiling) {
  const std::vector<VertexIndex> former = tiling.table.compact();
  for (std::size_t k = 0; k < former.size(); ++k) {
    tiling.points[k] = tiling.points[former[k]];
    tiling.normals[k] = tiling.normals[former[k]];
    tiling.places[k] = tiling.places[former[k]];
  }
  tiling.points.resize(former.size());
  tiling.normals.resize(former.size());
  tiling.places.resize(former.size());
}

TriangleMesh to_mesh(const Tiling& tiling) {
  Tiling dense = tiling;
  compact(dense);
  return {std::move(dense.points), dense.table.triangles()};
}

double mean_edge_length(const Tiling& tiling) {
  double sum = 0;
  std::size_t edges = 0;
  for (HalfEdge h = 0; h < tiling.table.half_edges(); ++h) {
    if (!tiling.table.is_edge(h)) continue;
    sum += (tiling.points[tiling.table.target(h)] - tiling.points[tiling.table.origin(h)]).norm();
    ++edges;
  }
  return edges ? sum / static_cast<double>(edges) : 0;
}

}  // namespace nanocarbon
