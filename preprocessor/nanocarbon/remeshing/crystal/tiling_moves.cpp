// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/crystal/tiling_moves.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

#include "nanocarbon/remeshing/crystal/soundness.h"

namespace nanocarbon::crystal {

bool relax_vertex(Tiling& tiling, VertexIndex v, double share) {
  if (tiling.is_held(v)) return false;
  const CornerTable& table = tiling.table;
  Vec3 mean = Vec3::Zero();
  int count = 0;
  const bool boundary = table.on_boundary(v);
  table.for_neighbours(v, [&](VertexIndex u) {
    if (boundary && !table.on_boundary(u)) return;
    mean += tiling.space().beside(tiling.points[u], tiling.points[v]);
    ++count;
  });
  if (boundary && count != 2) return false;
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

namespace {

struct PlacedVertex {
  Vec3 point;
  Vec3 normal;
  std::uint32_t place;
};

//! The middle between a and b, moved to the surface or, for the edge between two boundary vertices, to the
//! boundary.
PlacedVertex between(const Tiling& tiling, VertexIndex a, VertexIndex b, bool boundary) {
  const SurfaceGuide& guide = *tiling.guide;
  const Vec3 middle = 0.5 * (tiling.points[a] + tiling.space().beside(tiling.points[b], tiling.points[a]));
  if (boundary) {
    const BoundaryFoot one = guide.follow_boundary(middle, tiling.places[a]);
    const BoundaryFoot two = guide.follow_boundary(middle, tiling.places[b]);
    const BoundaryFoot& foot =
        (one.point - middle).squaredNorm() <= (two.point - middle).squaredNorm() ? one : two;
    return {foot.point, guide.boundary_normal(foot), foot.edge};
  }
  const Foot foot = guide.nearest(middle, tiling.normals[a] + tiling.normals[b], corner(tiling, a).triangle);
  return {foot.point, guide.normal(foot), foot.triangle};
}

void add_vertex(Tiling& tiling, const PlacedVertex& vertex) {
  tiling.points.push_back(vertex.point);
  tiling.normals.push_back(vertex.normal);
  tiling.places.push_back(vertex.place);
  if (!tiling.held.empty()) tiling.held.push_back(free_vertex);
}

}  // namespace

bool split_edge(Tiling& tiling, HalfEdgeIndex h) {
  const SurfaceGuide& guide = *tiling.guide;
  const CornerTable& table = tiling.table;
  const bool boundary = table.twin(h) == no_half_edge;
  const VertexIndex a = table.origin(h), b = table.target(h);
  for (const HalfEdgeIndex side : {h, table.twin(h)})
    if (side != no_half_edge && tiling.is_held(table.apex(side))) return false;
  const PlacedVertex middle = between(tiling, a, b, boundary);
  const Corner m = {middle.point, middle.normal, boundary ? middle.place / 3 : middle.place};
  double before = 1, after = 1;
  for (const HalfEdgeIndex side : {h, table.twin(h)}) {
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
    bool boundary;
  };
  std::vector<Edge> ends;
  for (HalfEdgeIndex h = 0; h < coarse.half_edges(); ++h) {
    if (!coarse.is_edge(h)) continue;
    middle[h] = old_vertices + static_cast<VertexIndex>(ends.size());
    if (coarse.twin(h) != no_half_edge) middle[coarse.twin(h)] = middle[h];
    ends.push_back({coarse.origin(h), coarse.target(h), coarse.twin(h) == no_half_edge});
  }
  TriangleMesh fine;
  fine.points.resize(old_vertices + ends.size());
  for (HalfEdgeIndex h = 0; h < coarse.half_edges(); h += 3) {
    const VertexIndex a = coarse.origin(h), b = coarse.origin(h + 1), c = coarse.origin(h + 2);
    const VertexIndex ab = middle[h], bc = middle[h + 1], ca = middle[h + 2];
    for (const Triangle& t : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
      fine.triangles.push_back(t);
  }
  for (const Edge& edge : ends) add_vertex(tiling, between(tiling, edge.a, edge.b, edge.boundary));
  tiling.table = CornerTable(fine);
}

namespace {

//! Adds the vertices within so many edges of one.
void add_surroundings(const CornerTable& table, VertexIndex v, int reach, std::set<VertexIndex>& vertices) {
  std::vector<VertexIndex> shell = {v};
  std::set<VertexIndex> seen = {v};
  for (int step = 0; step < reach; ++step) {
    std::vector<VertexIndex> next;
    for (const VertexIndex u : shell)
      table.for_neighbours(u, [&](VertexIndex w) {
        if (seen.insert(w).second) next.push_back(w);
      });
    shell = std::move(next);
  }
  vertices.merge(seen);
}

//! Moves a vertex and flips edges around it until it is sound, or nothing helps.
void unfold_around(Tiling& tiling, VertexIndex v) {
  CornerTable& table = tiling.table;
  relax_vertex(tiling, v, 1.0);
  std::vector<HalfEdgeIndex> candidates;
  table.for_outgoing(v, [&](HalfEdgeIndex h) {
    candidates.insert(candidates.end(), {h, CornerTable::next(h)});
  });
  for (const HalfEdgeIndex h : candidates) {
    if (soundness_around(tiling, v) >= 0) break;
    const HalfEdgeIndex o = table.twin(h);
    if (!flip_is_sound(tiling, h)) continue;
    const std::array<VertexIndex, 4> corners = {table.origin(h), table.target(h), table.apex(h),
                                                table.apex(o)};
    const auto least = [&] {
      double s = 1;
      for (const VertexIndex c : corners) s = std::min(s, soundness_around(tiling, c));
      return s;
    };
    const double was = least();
    table.flip(h);
    if (least() > was) break;
    table.flip(CornerTable::next(h));
  }
}

}  // namespace

// As going through all vertices in order, round by round; only those are looked at that are unsound at the start
// or near one that was.
std::size_t unfold(Tiling& tiling, int rounds) {
  constexpr int reach =
      4;  // edges: as far as a move and flips around a vertex change the soundness of others
  const std::vector<VertexIndex> unsound = unsound_vertices(tiling);
  std::set<VertexIndex> candidates(unsound.begin(), unsound.end());
  std::size_t left = candidates.size();
  for (int round = 0; round < rounds && left > 0; ++round) {
    left = 0;
    for (auto next = candidates.begin(); next != candidates.end(); ++next) {
      const VertexIndex v = *next;
      if (tiling.is_held(v) || soundness_around(tiling, v) >= 0) continue;
      ++left;
      unfold_around(tiling, v);
      add_surroundings(tiling.table, v, reach, candidates);
    }
  }
  return left;
}

}  // namespace nanocarbon::crystal
