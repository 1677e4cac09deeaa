// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/shapes/mesh_boundaries.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace nanocarbon::shapes {
namespace {

struct DirectedEdge {
  VertexIndex from, to;
  friend auto operator<=>(const DirectedEdge&, const DirectedEdge&) = default;
};

std::vector<DirectedEdge> sorted_edges(const TriangleMesh& mesh) {
  std::vector<DirectedEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles)
    for (int c = 0; c < 3; ++c) edges.push_back({t[c], t[(c + 1) % 3]});
  std::sort(edges.begin(), edges.end());
  return edges;
}

//! The triangle (vertex, from, to).
struct Side {
  VertexIndex vertex, from, to;
  friend auto operator<=>(const Side&, const Side&) = default;
};

//! Whether the triangles at each vertex form one fan: walking over shared edges from one reaches them all.
bool single_fans(const TriangleMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles)
    for (int c = 0; c < 3; ++c) sides.push_back({t[c], t[(c + 1) % 3], t[(c + 2) % 3]});
  std::sort(sides.begin(), sides.end());
  for (auto first = sides.begin(); first != sides.end();) {
    const auto last =
        std::find_if(first, sides.end(), [&](const Side& s) { return s.vertex != first->vertex; });
    const auto follow = [&](VertexIndex from) {
      const auto it = std::lower_bound(first, last, Side{first->vertex, from, 0});
      return it != last && it->from == from ? it : last;
    };
    // An open fan starts at the side nothing leads to.
    auto start = first;
    for (auto s = first; s != last; ++s)
      if (std::none_of(first, last, [&](const Side& other) { return other.to == s->from; })) start = s;
    std::ptrdiff_t met = 0;
    for (auto s = start; s != last && met <= last - first; s = follow(s->to)) {
      ++met;
      if (s->to == start->from) break;
    }
    if (met != last - first) return false;
    first = last;
  }
  return true;
}

}  // namespace

ManifoldCheck check_manifold(const TriangleMesh& mesh) {
  ManifoldCheck check{true, std::vector<bool>(mesh.points.size(), false)};
  const std::vector<DirectedEdge> edges = sorted_edges(mesh);
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) check.manifold = false;
  for (const DirectedEdge& e : edges)
    if (!std::binary_search(edges.begin(), edges.end(), DirectedEdge{e.to, e.from}))
      check.on_boundary[e.from] = check.on_boundary[e.to] = true;
  if (check.manifold) check.manifold = single_fans(mesh);
  return check;
}

void drop_unused_points(TriangleMesh& mesh) {
  constexpr VertexIndex unused = std::numeric_limits<VertexIndex>::max();
  std::vector<VertexIndex> index(mesh.points.size(), unused);
  for (const Triangle& t : mesh.triangles)
    for (const VertexIndex v : t) index[v] = 0;
  VertexIndex kept = 0;
  for (std::size_t v = 0; v < index.size(); ++v) {
    if (index[v] == unused) continue;
    mesh.points[kept] = mesh.points[v];
    index[v] = kept++;
  }
  mesh.points.resize(kept);
  for (Triangle& t : mesh.triangles)
    for (VertexIndex& v : t) v = index[v];
}

}  // namespace nanocarbon::shapes
