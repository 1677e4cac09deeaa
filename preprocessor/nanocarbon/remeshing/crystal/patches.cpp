// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/crystal/patches.h"

#include <algorithm>
#include <limits>

#include "nanocarbon/core/disjoint_sets.h"

namespace nanocarbon::crystal {
namespace {

constexpr int far = std::numeric_limits<int>::max();

//! Edges from each vertex to the nearest of some, if there are not more than `reach`.
std::vector<int> distances(const CornerTable& table, std::span<const VertexIndex> from, int reach) {
  std::vector<int> distance(table.vertices(), far);
  std::vector<VertexIndex> reached;
  const auto meet = [&](VertexIndex v, int d) {
    if (distance[v] != far) return;
    distance[v] = d;
    reached.push_back(v);
  };
  for (const VertexIndex v : from) meet(v, 0);
  for (std::size_t k = 0; k < reached.size(); ++k) {
    const VertexIndex v = reached[k];
    if (distance[v] < reach) table.for_neighbours(v, [&](VertexIndex u) { meet(u, distance[v] + 1); });
  }
  return distance;
}

//! A patch of some triangles.
Patch cut_out(const Tiling& whole, std::vector<std::uint32_t> triangles, const std::vector<int>& distance,
              int reach, std::vector<VertexIndex>& number) {
  Patch patch;
  Tiling& part = patch.tiling;
  part.guide = whole.guide;
  TriangleMesh mesh;
  std::vector<VertexIndex> numbered;
  for (const std::uint32_t t : triangles) {
    Triangle& own = mesh.triangles.emplace_back();
    for (HalfEdgeIndex k = 0; k < 3; ++k) {
      const VertexIndex v = whole.table.origin(3 * t + k);
      if (number[v] == free_vertex) {
        number[v] = static_cast<VertexIndex>(part.points.size());
        numbered.push_back(v);
        part.points.push_back(whole.points[v]);
        part.normals.push_back(whole.normals[v]);
        part.places.push_back(whole.places[v]);
        part.held.push_back(distance[v] >= reach - 1 ? v : free_vertex);
      }
      own[k] = number[v];
    }
  }
  mesh.points.resize(part.points.size());
  part.table = CornerTable(mesh);
  for (const VertexIndex v : numbered) number[v] = free_vertex;
  patch.triangles = std::move(triangles);
  return patch;
}

}  // namespace

std::vector<Patch> surroundings(const Tiling& whole, std::span<const VertexIndex> around, int reach) {
  const CornerTable& table = whole.table;
  const std::vector<int> distance = distances(table, around, reach);
  const std::size_t count = table.half_edges() / 3;
  const auto inside = [&](std::size_t t) {
    const auto h = static_cast<HalfEdgeIndex>(3 * t);
    return distance[table.origin(h)] != far && distance[table.origin(h + 1)] != far &&
           distance[table.origin(h + 2)] != far;
  };
  DisjointSets parts(table.vertices());
  for (std::size_t t = 0; t < count; ++t)
    if (inside(t))
      for (HalfEdgeIndex k = 1; k < 3; ++k)
        parts.join(table.origin(static_cast<HalfEdgeIndex>(3 * t)),
                   table.origin(static_cast<HalfEdgeIndex>(3 * t) + k));
  std::vector<std::vector<std::uint32_t>> triangles;
  std::vector<std::size_t> part_of(table.vertices(), 0);  // one more than its number
  for (std::size_t t = 0; t < count; ++t) {
    if (!inside(t)) continue;
    std::size_t& part = part_of[parts.find(table.origin(static_cast<HalfEdgeIndex>(3 * t)))];
    if (part == 0) {
      triangles.emplace_back();
      part = triangles.size();
    }
    triangles[part - 1].push_back(static_cast<std::uint32_t>(t));
  }
  std::vector<VertexIndex> number(table.vertices(), free_vertex);
  std::vector<Patch> patches;
  for (std::vector<std::uint32_t>& part : triangles)
    patches.push_back(cut_out(whole, std::move(part), distance, reach, number));
  return patches;
}

void replace(Tiling& whole, std::span<const Patch> patches) {
  std::vector<bool> gone(whole.table.half_edges() / 3, false);
  for (const Patch& patch : patches)
    for (const std::uint32_t t : patch.triangles) gone[t] = true;
  TriangleMesh mesh;
  const std::vector<Triangle> all = whole.table.triangles();
  for (std::size_t t = 0; t < all.size(); ++t)
    if (!gone[t]) mesh.triangles.push_back(all[t]);
  for (const Patch& patch : patches) {
    const Tiling& part = patch.tiling;
    std::vector<VertexIndex> number(part.points.size());
    for (VertexIndex v = 0; v < part.points.size(); ++v) {
      if (!part.table.vertex_alive(v)) continue;
      if (part.is_held(v)) {
        number[v] = part.held[v];
        continue;
      }
      number[v] = static_cast<VertexIndex>(whole.points.size());
      whole.points.push_back(part.points[v]);
      whole.normals.push_back(part.normals[v]);
      whole.places.push_back(part.places[v]);
    }
    for (const Triangle& t : part.table.triangles())
      mesh.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  }
  mesh.points.resize(whole.points.size());
  whole.table = CornerTable(mesh);
  compact(whole);
}

}  // namespace nanocarbon::crystal
