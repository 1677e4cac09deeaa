// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/merge_close_vertices.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "nanocarbon/mesh/edge_table.h"

namespace nanocarbon::mesh {
namespace {

struct ShortEdge {
  VertexIndex keep, lose;
  double length;
  std::size_t faces;
  bool moves;  // whether the one that is kept goes to the middle
};

class Merging {
 public:
  Merging(TriangleMesh& mesh, double shorter_than, MergedEdges which,
          const std::function<bool(VertexIndex)>& movable)
      : mesh_(mesh), shorter_than_(shorter_than), which_(which), movable_(movable) {}

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
      const VertexIndex keep = edge.keep, lose = edge.lose;
      std::vector<VertexIndex> around = neighbours(keep);
      for (const VertexIndex v : neighbours(lose)) around.push_back(v);
      if (std::any_of(around.begin(), around.end(), [&](VertexIndex v) { return bool(touched[v]); }) ||
          !may_merge(edge))
        continue;
      for (const VertexIndex v : around) touched[v] = true;
      if (edge.moves) mesh_.points[keep] = 0.5 * (mesh_.points[keep] + mesh_.points[lose]);
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
    std::vector<bool> at_boundary(mesh_.points.size(), false);
    for (std::size_t e = 0; e < edges.size(); ++e)
      if (edges.uses_of(e).size() == 1) at_boundary[edges.low[e]] = at_boundary[edges.high[e]] = true;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      VertexIndex keep = edges.low[e], lose = edges.high[e];
      const std::size_t faces = edges.uses_of(e).size();
      const double length = (mesh_.points[lose] - mesh_.points[keep]).norm();
      if (faces > 2 || !(length < shorter_than_)) continue;
      if (faces == 2 && (which_ == MergedEdges::boundary || (at_boundary[keep] && at_boundary[lose])))
        continue;
      // The boundary keeps its line, and what may not move its place.
      const auto fixed = [&](VertexIndex v) { return !movable_(v) || (faces == 2 && at_boundary[v]); };
      if (fixed(lose)) std::swap(keep, lose);
      if (!fixed(lose)) found.push_back({keep, lose, length, faces, !fixed(keep)});
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

  // Where the ends have only the third corners of their triangles in common, and there are other triangles:
  // more than a tetrahedron's.
  bool may_merge(const ShortEdge& edge) const {
    const std::vector<VertexIndex> of_one = neighbours(edge.keep), of_other = neighbours(edge.lose);
    std::vector<VertexIndex> common;
    std::set_intersection(of_one.begin(), of_one.end(), of_other.begin(), of_other.end(),
                          std::back_inserter(common));
    return common.size() == 2 + edge.faces &&
           faces_at_[edge.keep].size() + faces_at_[edge.lose].size() > (edge.faces == 2 ? 6u : 2u);
  }

  TriangleMesh& mesh_;
  const double shorter_than_;
  const MergedEdges which_;
  const std::function<bool(VertexIndex)>& movable_;
  std::vector<std::vector<FaceIndex>> faces_at_;
};

}  // namespace

std::size_t merge_close_vertices(TriangleMesh& mesh, double shorter_than, MergedEdges which,
                                 const std::function<bool(VertexIndex)>& movable) {
  return Merging(mesh, shorter_than, which, movable).run();
}

}  // namespace nanocarbon::mesh
