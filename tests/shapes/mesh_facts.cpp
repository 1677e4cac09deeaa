// SPDX-License-Identifier: GPL-2.0-or-later
#include "shapes/mesh_facts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

namespace nanocarbon::test {
namespace {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace

MeshFacts mesh_facts(const TriangleMesh& mesh) {
  MeshFacts f;
  f.manifold = true;
  std::map<std::pair<VertexIndex, VertexIndex>, std::size_t> triangle_of;  // by directed edge
  std::vector<Vec3> normal;
  std::set<VertexIndex> used;
  DisjointSets components(mesh.points.size());
  f.smallest_angle = 180.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& corner = mesh.triangles[t];
    const Vec3 a = mesh.points[corner[0]], b = mesh.points[corner[1]], c = mesh.points[corner[2]];
    const Vec3 cross = (b - a).cross(c - a);
    normal.push_back(cross.normalized());
    f.area += 0.5 * cross.norm();
    f.volume += a.dot(b.cross(c)) / 6.0;
    for (int i = 0; i < 3; ++i) {
      used.insert(corner[i]);
      components.join(corner[0], corner[i]);
      if (!triangle_of.insert({{corner[i], corner[(i + 1) % 3]}, t}).second) f.manifold = false;
      const Vec3 u = mesh.points[corner[(i + 1) % 3]] - mesh.points[corner[i]];
      const Vec3 v = mesh.points[corner[(i + 2) % 3]] - mesh.points[corner[i]];
      f.smallest_angle =
          std::min(f.smallest_angle, std::atan2(u.cross(v).norm(), u.dot(v)) * 180.0 / std::numbers::pi);
    }
  }

  std::size_t edges = 0, inner = 0;
  std::map<VertexIndex, std::size_t> triangles_at, inner_at;
  std::map<VertexIndex, VertexIndex> next_on_boundary;
  double sum = 0.0;
  f.shortest_edge = std::numeric_limits<double>::infinity();
  for (const Triangle& t : mesh.triangles)
    for (const VertexIndex v : t) ++triangles_at[v];
  for (const auto& [edge, t] : triangle_of) {
    const auto other = triangle_of.find({edge.second, edge.first});
    if (other == triangle_of.end()) {
      if (!next_on_boundary.insert({edge.second, edge.first}).second) f.manifold = false;
    } else if (edge.first > edge.second) {
      continue;
    } else {
      ++inner, ++inner_at[edge.first], ++inner_at[edge.second];
      const double cosine = std::clamp(normal[t].dot(normal[other->second]), -1.0, 1.0);
      f.sharpest_fold = std::max(f.sharpest_fold, std::acos(cosine) * 180.0 / std::numbers::pi);
    }
    ++edges;
    const double length = (mesh.points[edge.first] - mesh.points[edge.second]).norm();
    sum += length;
    f.shortest_edge = std::min(f.shortest_edge, length);
    f.longest_edge = std::max(f.longest_edge, length);
  }
  f.mean_edge = sum / static_cast<double>(edges);
  // With k triangles around a vertex, a full fan has k inner edges, an open one k - 1; two fans have k or k -
  // 2 ones. Two full fans look like one by this count: walk around each closed vertex to tell.
  for (const auto& [v, count] : triangles_at) {
    f.largest_valence = std::max(f.largest_valence, count);
    if (next_on_boundary.contains(v)) {
      if (inner_at[v] + 1 != count) f.manifold = false;
    }
  }
  std::set<VertexIndex> seen;
  for (const auto& [edge, t] : triangle_of) {
    if (next_on_boundary.contains(edge.first) || !seen.insert(edge.first).second) continue;
    std::size_t steps = 0;
    auto at = edge;
    do {
      const Triangle& corner = mesh.triangles[triangle_of.at(at)];
      const auto place = std::find(corner.begin(), corner.end(), at.first) - corner.begin();
      at = {at.first, corner[(place + 2) % 3]};
      ++steps;
    } while (at != edge && triangle_of.contains(at) && steps <= triangles_at[edge.first]);
    if (steps != triangles_at[edge.first]) f.manifold = false;
  }

  std::set<VertexIndex> on_boundary;
  for (const auto& [v, next] : next_on_boundary) {
    if (on_boundary.contains(v)) continue;
    ++f.boundaries;
    for (VertexIndex w = v; on_boundary.insert(w).second && next_on_boundary.contains(w);)
      w = next_on_boundary.at(w);
  }
  std::set<std::size_t> roots;
  for (const VertexIndex v : used) roots.insert(components.root(v));
  f.components = roots.size();
  f.euler_characteristic =
      static_cast<long>(used.size()) - static_cast<long>(edges) + static_cast<long>(mesh.triangles.size());
  if (used.size() != mesh.points.size()) f.manifold = false;  // points that belong to nothing
  return f;
}

}  // namespace nanocarbon::test
