// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/self_intersections.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <tuple>

#include "nanocarbon/core/disjoint_sets.h"
#include "nanocarbon/core/neighbours_within.h"
#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/triangle_intersection.h"
#include "nanocarbon/mesh/triangle_tree.h"

namespace nanocarbon::mesh {
namespace {

constexpr std::size_t most_pairs = 100'000;
constexpr std::size_t most_tries_per_triangle = 64;  // a surface of even triangles needs about 10
constexpr std::size_t tries_always_allowed = 20'000'000;

// Images of one vertex differ by rounding; others are farther apart. Share of the cell's least width.
constexpr double same_vertex = 1e-9;

// Of two triangles in a cell, each in a place of its own: what they share is told by place.
bool intersect_in_place(const std::array<Vec3, 3>& first, const std::array<Vec3, 3>& second, double same) {
  TriangleMesh pair{{first[0], first[1], first[2]}, {}};
  Triangle other;
  for (std::size_t k = 0; k < 3; ++k) {
    other[k] = static_cast<VertexIndex>(pair.points.size());
    for (VertexIndex v = 0; v < 3; ++v)
      if ((first[v] - second[k]).squaredNorm() < same * same) other[k] = v;
    if (other[k] == pair.points.size()) pair.points.push_back(second[k]);
  }
  return intersect(pair, {0, 1, 2}, other);
}

// By number, each once: small triangles meet through one image only.
void sort_pairs(SelfIntersections& found) {
  std::vector<std::size_t> order(found.pairs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tie(found.pairs[a], a) < std::tie(found.pairs[b], b);
  });
  SelfIntersections sorted;
  sorted.complete = found.complete;
  for (const std::size_t k : order) {
    if (!sorted.pairs.empty() && sorted.pairs.back() == found.pairs[k]) continue;
    sorted.pairs.push_back(found.pairs[k]);
    if (!found.moved.empty()) sorted.moved.push_back(found.moved[k]);
  }
  found = std::move(sorted);
}

// The pairs of triangles of a mesh whose boxes overlap are tried; in a cell in every image.
class Search {
 public:
  explicit Search(const TriangleMesh& mesh)
      : mesh_(mesh),
        tree_(triangle_tree(mesh)),
        boxes_(mesh.triangles.size()),
        same_(mesh.space.periodic() ? same_vertex * mesh.space.least_width() : 0.0) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (const Vec3& corner : corners_in_cell(mesh, mesh.triangles[t])) boxes_[t].include(corner);
  }

  SelfIntersections run() {
    const std::size_t most_tries = tries_always_allowed + most_tries_per_triangle * mesh_.triangles.size();
    for (const std::uint32_t first : tree_.triangles) {
      mesh_.space.for_images([&](const Vec3& shift) { visit(first, shift); });
      if (tries_ > most_tries || result_.pairs.size() > most_pairs) {
        result_.complete = false;
        break;
      }
    }
    sort_pairs(result_);
    return std::move(result_);
  }

 private:
  // The first triangle, moved by a translation of the cell, against those that come after it.
  void visit(std::uint32_t first, const Vec3& shift) {
    const BoundingBox box{boxes_[first].low + shift, boxes_[first].high + shift};
    visit_triangles(
        tree_, [&](const BoundingBox& other) { return overlap(box, other); },
        [&](std::uint32_t second) {
          if (second <= first || !overlap(box, boxes_[second])) return;
          ++tries_;
          if (!meet(first, second, shift)) return;
          result_.pairs.push_back({first, second});
          if (mesh_.space.periodic()) result_.moved.push_back(shift + to_cell(first) - to_cell(second));
        });
  }

  // What leads from the first corner as it is to where corners_in_cell() has it.
  Vec3 to_cell(std::uint32_t triangle) const {
    const Vec3& corner = mesh_.points[mesh_.triangles[triangle][0]];
    return mesh_.space.wrapped(corner) - corner;
  }

  bool meet(std::uint32_t first, std::uint32_t second, const Vec3& shift) const {
    const Triangle &one = mesh_.triangles[first], &other = mesh_.triangles[second];
    if (!mesh_.space.periodic()) return intersect(mesh_, one, other);
    std::array<Vec3, 3> moved = corners_in_cell(mesh_, one);
    for (Vec3& corner : moved) corner += shift;
    return intersect_in_place(moved, corners_in_cell(mesh_, other), same_);
  }

  const TriangleMesh& mesh_;
  const TriangleTree tree_;
  std::vector<BoundingBox> boxes_;
  const double same_;
  std::size_t tries_ = 0;
  SelfIntersections result_;
};

// The two faces at an edge, with what leads from its first vertex to their third ones.
struct Wedge {
  std::array<std::uint32_t, 2> faces;
  std::array<Vec3, 2> arms;
  Vec3 from;  // beside the first corner of the first face
  Vec3 along;
};

// Whether two surfaces pass through each other at an edge that both have: going round it, their faces take turns.
bool take_turns(const Wedge& one, const Wedge& other) {
  const Vec3 axis = one.along.normalized();
  const auto across = [&](const Vec3& arm) { return Vec3(arm - arm.dot(axis) * axis); };
  const Vec3 x = across(one.arms[0]).normalized(), y = axis.cross(x);
  const auto angle = [&](const Vec3& arm) {
    const double a = std::atan2(arm.dot(y), arm.dot(x));
    return a < 0 ? a + 2 * std::numbers::pi : a;
  };
  constexpr double apart = 1e-9;  // faces upon each other are found as such
  const double end = angle(one.arms[1]);
  int inside = 0;
  for (const Vec3& arm : other.arms) {
    const double a = angle(arm);
    if (a < apart || a > 2 * std::numbers::pi - apart || std::abs(a - end) < apart) return false;
    inside += a < end ? 1 : 0;
  }
  return inside == 1;
}

}  // namespace

SelfIntersections self_intersections(const TriangleMesh& mesh) { return Search(mesh).run(); }

void add_crossings_in_edges(const TriangleMesh& mesh, std::span<const VertexIndex> same_place,
                            SelfIntersections& found) {
  std::vector<bool> shared(mesh.points.size(), false);
  bool any = false;
  for (VertexIndex v = 0; v < same_place.size(); ++v)
    if (same_place[v] != v) shared[same_place[v]] = any = true;
  if (!any) return;
  const EdgeTable edges = edge_table(soup_of(mesh));
  std::map<std::array<VertexIndex, 2>, std::vector<std::size_t>> at_place;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const VertexIndex low = same_place[edges.low[e]], high = same_place[edges.high[e]];
    if (shared[low] && shared[high] && edges.uses_of(e).size() == 2)
      at_place[{std::min(low, high), std::max(low, high)}].push_back(e);
  }
  const auto wedge = [&](std::size_t e, VertexIndex first) {
    const VertexIndex from = same_place[edges.low[e]] == first ? edges.low[e] : edges.high[e];
    const VertexIndex to = from == edges.low[e] ? edges.high[e] : edges.low[e];
    Wedge result;
    result.along = mesh.space.displacement(mesh.points[from], mesh.points[to]);
    for (std::size_t k = 0; k < 2; ++k) {
      const EdgeUse& use = edges.uses_of(e)[k];
      const VertexIndex apex = mesh.triangles[use.face][(use.corner + 2) % 3];
      result.faces[k] = use.face;
      result.arms[k] = mesh.space.displacement(mesh.points[from], mesh.points[apex]);
    }
    result.from = mesh.space.beside(mesh.points[from], mesh.points[mesh.triangles[result.faces[0]][0]]);
    return result;
  };
  for (const auto& [place, there] : at_place)
    for (std::size_t i = 0; i < there.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Wedge one = wedge(there[i], place[0]), other = wedge(there[j], place[0]);
        if (!take_turns(one, other)) continue;
        const bool ordered = one.faces[0] < other.faces[0];
        const Wedge &low = ordered ? one : other, &high = ordered ? other : one;
        found.pairs.push_back({low.faces[0], high.faces[0]});
        if (mesh.space.periodic()) found.moved.push_back(high.from - low.from);
      }
  sort_pairs(found);
}

SelfIntersections crossings(const TriangleMesh& mesh, std::span<const VertexIndex> same_place) {
  TriangleMesh joined = mesh;
  for (Triangle& triangle : joined.triangles)
    for (VertexIndex& v : triangle) v = same_place[v];
  SelfIntersections found = self_intersections(joined);
  add_crossings_in_edges(mesh, same_place, found);
  return found;
}

std::vector<VertexIndex> first_at_place(const TriangleMesh& mesh) {
  DisjointSets places(mesh.points.size());
  if (mesh.space.periodic()) {
    const NeighbourList near =
        neighbours_within(mesh.points, mesh.space.cell(), same_vertex * mesh.space.least_width());
    for (VertexIndex v = 0; v < mesh.points.size(); ++v)
      for (const Neighbour& other : near.of(v)) places.join(v, other.atom);
  }
  std::vector<VertexIndex> first(mesh.points.size());
  for (VertexIndex v = 0; v < first.size(); ++v) first[v] = places.find(v);
  return first;
}

}  // namespace nanocarbon::mesh
