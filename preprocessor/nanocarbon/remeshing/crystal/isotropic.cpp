// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/crystal/isotropic.h"

#include <algorithm>
#include <vector>

#include "nanocarbon/remeshing/crystal/flips.h"
#include "nanocarbon/remeshing/crystal/soundness.h"
#include "nanocarbon/remeshing/crystal/tiling_moves.h"

namespace nanocarbon::crystal {
namespace {

double squared_length(const Tiling& tiling, HalfEdgeIndex h) {
  return tiling.between(tiling.table.origin(h), tiling.table.target(h)).squaredNorm();
}

std::size_t split_long_edges(Tiling& tiling, double limit) {
  std::size_t splits = 0;
  // Not what is added on the way: the next round sees it, and no edge is split without end.
  const HalfEdgeIndex end = static_cast<HalfEdgeIndex>(tiling.table.half_edges());
  for (HalfEdgeIndex h = 0; h < end; ++h)
    if (tiling.table.is_edge(h) && squared_length(tiling, h) > limit * limit) {
      splits += split_edge(tiling, h) ? 1 : 0;
    }
  return splits;
}

std::size_t collapse_short_edges(Tiling& tiling, double limit, double longest) {
  std::size_t collapses = 0;
  for (HalfEdgeIndex h = 0; h < tiling.table.half_edges(); ++h)
    if (tiling.table.is_edge(h) && squared_length(tiling, h) < limit * limit)
      collapses += try_collapse(tiling, h, longest) ? 1 : 0;
  return collapses;
}

//! Edges by length, the shortest first; ties by index.
std::vector<HalfEdgeIndex> sorted_edges(const Tiling& tiling) {
  std::vector<std::pair<double, HalfEdgeIndex>> keyed;
  for (HalfEdgeIndex h = 0; h < tiling.table.half_edges(); ++h)
    if (tiling.table.is_edge(h)) keyed.emplace_back(squared_length(tiling, h), h);
  std::sort(keyed.begin(), keyed.end());
  std::vector<HalfEdgeIndex> edges(keyed.size());
  std::transform(keyed.begin(), keyed.end(), edges.begin(), [](const auto& k) { return k.second; });
  return edges;
}

}  // namespace

bool try_collapse(Tiling& tiling, HalfEdgeIndex h, double longest) {
  CornerTable& table = tiling.table;
  if (table.on_boundary(table.origin(h)) && !table.on_boundary(table.target(h))) h = table.twin(h);
  const VertexIndex a = table.origin(h), b = table.target(h);
  if (!table.can_collapse(h)) return false;
  for (const HalfEdgeIndex side : {h, table.twin(h)})
    if (side != no_half_edge && (tiling.is_held(table.origin(side)) || tiling.is_held(table.target(side)) ||
                                 tiling.is_held(table.apex(side))))
      return false;
  const double before = std::min(soundness_around(tiling, a), soundness_around(tiling, b));
  const Vec3 old_point = tiling.points[b], old_normal = tiling.normals[b];
  const std::uint32_t old_place = tiling.places[b];
  if (table.on_boundary(a) == table.on_boundary(b))
    place_vertex(tiling, b, 0.5 * (tiling.space().beside(tiling.points[a], old_point) + old_point));
  bool short_enough = true;
  for (const VertexIndex v : {a, b})
    table.for_neighbours(v, [&](VertexIndex u) {
      short_enough = short_enough && tiling.between(u, b).squaredNorm() < longest * longest;
    });
  if (!short_enough || !collapse_is_sound(tiling, h, before)) {
    tiling.points[b] = old_point;
    tiling.normals[b] = old_normal;
    tiling.places[b] = old_place;
    return false;
  }
  table.collapse(h);
  return true;
}

void smooth_tangentially(Tiling& tiling, int rounds) {
  for (int round = 0; round < rounds; ++round)
    for (VertexIndex v = 0; v < tiling.table.vertices(); ++v)
      if (tiling.table.vertex_alive(v)) relax_vertex(tiling, v, 0.8);
}

IsotropicResult remesh_isotropically(Tiling& tiling, double edge_length, int rounds) {
  IsotropicResult result;
  for (int round = 0; round < rounds; ++round) {
    result.splits += split_long_edges(tiling, 4.0 / 3.0 * edge_length);
    result.collapses += collapse_short_edges(tiling, 0.8 * edge_length, 4.0 / 3.0 * edge_length);
    compact(tiling);
    result.flips += flip_to_delaunay(tiling, 3);
    smooth_tangentially(tiling, 2);
    unfold(tiling, 3);
  }
  return result;
}

std::size_t reach_vertex_count(Tiling& tiling, std::size_t vertices) {
  constexpr int most_rounds = 40;
  for (int round = 0; round < most_rounds; ++round) {
    const std::size_t now = tiling.table.live_vertices();
    if (now == vertices) break;
    // A tenth at a time, so that smoothing can spread what is added or taken away.
    const std::size_t wanted = now < vertices ? vertices - now : now - vertices;
    std::size_t left = std::min(wanted, std::max<std::size_t>(now / 10, 8));
    std::vector<HalfEdgeIndex> edges = sorted_edges(tiling);
    if (now < vertices) {
      for (auto h = edges.rbegin(); h != edges.rend() && left > 0; ++h)
        left -= split_edge(tiling, *h) ? 1 : 0;
    } else {
      const double longest = 1.5 * mean_edge_length(tiling);
      for (const HalfEdgeIndex h : edges) {
        if (left == 0) break;
        if (tiling.table.alive(h) && try_collapse(tiling, h, longest)) --left;
      }
    }
    compact(tiling);
    flip_to_delaunay(tiling, 5);
    smooth_tangentially(tiling, 2);
    unfold(tiling, 3);
  }
  return tiling.table.live_vertices();
}

}  // namespace nanocarbon::crystal
