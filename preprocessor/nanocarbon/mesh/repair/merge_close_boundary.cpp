// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/merge_close_boundary.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "nanocarbon/mesh/edge_table.h"

namespace nanocarbon::mesh {
namespace {

struct ShortEdge {
  VertexIndex from, to;
  double length;
};

class Merging {
 public:
  Merging(TriangleMesh& mesh, double shorter_than, const std::function<bool(VertexIndex)>& movable)
      : mesh_(mesh), shorter_than_(shorter_than), movable_(movable) {}

  std::size_t run() {
    std::size_t merged = 0;
    while (const std::size_t more = pass()) merged += more;
    return merged;
  }

 private:
  // The shortest edges first; what is beside a merged one waits for the next pass.
  std::size_t pass() {
    list_triangles();
    std::vector<bool> touched(mesh_.points.size(), false), dropped(mesh_.triangles.size(), false);
    std::size_t merged = 0;
    for (const ShortEdge& edge : short_edges()) {
      const VertexIndex keep = movable_(edge.to) ? edge.from : edge.to,
                        lose = keep == edge.from ? edge.to : edge.from;
      std::vector<VertexIndex> around = neighbours(keep);
      for (const VertexIndex v : neighbours(lose)) around.push_back(v);
      if (std::any_of(around.begin(), around.end(), [&](VertexIndex v) { return bool(touched[v]); }) ||
          !may_merge(keep, lose))
        continue;
      for (const VertexIndex v : around) touched[v] = true;
      if (movable_(keep)) mesh_.points[keep] = 0.5 * (mesh_.points[keep] + mesh_.points[lose]);
      for (const FaceIndex f : faces_at_[lose]) {
        Triangle& t = mesh_.triangles[f];
        dropped[f] = std::find(t.begin(), t.end(), keep) != t.end();
        std::replace(t.begin(), t.end(), lose, keep);
      }
      ++merged;
    }
    std::size_t next = 0;
    std::erase_if(mesh_.triangles, [&](const Triangle&) { return dropped[next++]; });
    return merged;
  }

  void list_triangles() {
    faces_at_.assign(mesh_.points.size(), {});
    for (FaceIndex f = 0; f < mesh_.triangles.size(); ++f)
      for (const VertexIndex v : mesh_.triangles[f]) faces_at_[v].push_back(f);
  }

  std::vector<ShortEdge> short_edges() const {
    std::vector<ShortEdge> found;
    const EdgeTable edges = edge_table(soup_of(mesh_));
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const VertexIndex from = edges.low[e], to = edges.high[e];
      if (edges.uses_of(e).size() != 1 || (!movable_(from) && !movable_(to))) continue;
      const double length = (mesh_.points[to] - mesh_.points[from]).norm();
      if (length < shorter_than_) found.push_back({from, to, length});
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const ShortEdge& a, const ShortEdge& b) { return a.length < b.length; });
    return found;
  }

  // With the vertex itself, in order.
  std::vector<VertexIndex> neighbours(VertexIndex v) const {
    std::vector<VertexIndex> all;
    for (const FaceIndex f : faces_at_[v])
      for (const VertexIndex corner : mesh_.triangles[f]) all.push_back(corner);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  // Where the ends have only their triangle's third corner in common, and there are other triangles.
  bool may_merge(VertexIndex one, VertexIndex other) const {
    const std::vector<VertexIndex> of_one = neighbours(one), of_other = neighbours(other);
    std::vector<VertexIndex> common;
    std::set_intersection(of_one.begin(), of_one.end(), of_other.begin(), of_other.end(),
                          std::back_inserter(common));
    return common.size() == 3 && faces_at_[one].size() + faces_at_[other].size() > 2;
  }

  TriangleMesh& mesh_;
  const double shorter_than_;
  const std::function<bool(VertexIndex)>& movable_;
  std::vector<std::vector<FaceIndex>> faces_at_;
};

}  // namespace

std::size_t merge_close_boundary(TriangleMesh& mesh, double shorter_than,
                                 const std::function<bool(VertexIndex)>& movable) {
  return Merging(mesh, shorter_than, movable).run();
}

}  // namespace nanocarbon::mesh
