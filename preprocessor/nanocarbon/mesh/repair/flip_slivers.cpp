// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/flip_slivers.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/measures.h"

namespace nanocarbon::mesh {
namespace {

constexpr FaceIndex none = std::numeric_limits<FaceIndex>::max();

class Flipper {
 public:
  explicit Flipper(TriangleMesh& mesh) : mesh_(mesh), neighbour_(mesh.triangles.size(), {none, none, none}) {
    const EdgeTable edges = edge_table(soup_of(mesh));
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto uses = edges.uses_of(e);
      if (uses.size() != 2) continue;
      neighbour_[uses[0].face][uses[0].corner % 3] = uses[1].face;
      neighbour_[uses[1].face][uses[1].corner % 3] = uses[0].face;
    }
  }

  // Each flip either leaves fewer triangles without area or shortens the edges in all, and so it comes to an
  // end. The bound is for rounding.
  std::size_t flip() {
    std::vector<FaceIndex> waiting;
    for (FaceIndex t = 0; t < mesh_.triangles.size(); ++t)
      if (is_sliver(t)) waiting.push_back(t);
    std::size_t flips = 0;
    const std::size_t most = 20 * waiting.size();
    for (bool going = true; going && flips < most;) {
      going = false;
      std::vector<FaceIndex> left;
      for (const FaceIndex t : waiting) {
        if (!is_sliver(t)) continue;
        const FaceIndex other = flip_longest_side(t);
        left.push_back(t);
        if (other == none) continue;
        left.push_back(other);
        going = true;
        ++flips;
      }
      std::sort(left.begin(), left.end());
      left.erase(std::unique(left.begin(), left.end()), left.end());
      waiting = std::move(left);
    }
    return flips;
  }

 private:
  bool is_sliver(FaceIndex t) const { return has_no_area(mesh_.points, mesh_.triangles[t]); }

  double length(VertexIndex a, VertexIndex b) const { return (mesh_.points[a] - mesh_.points[b]).norm(); }

  // The side of a triangle that begins at a vertex.
  std::size_t side_from(FaceIndex t, VertexIndex vertex) const {
    const Triangle& corners = mesh_.triangles[t];
    return static_cast<std::size_t>(std::find(corners.begin(), corners.end(), vertex) - corners.begin());
  }

  // Whether an edge joins two vertices already; t is a triangle at `from`. Goes around `from` both ways.
  bool connected(FaceIndex t, VertexIndex from, VertexIndex to) const {
    for (const std::size_t backwards : {0u, 2u}) {
      FaceIndex at = t;
      do {
        const Triangle& corners = mesh_.triangles[at];
        if (std::find(corners.begin(), corners.end(), to) != corners.end()) return true;
        at = neighbour_[at][(side_from(at, from) + backwards) % 3];
      } while (at != none && at != t);
      if (at == t) return false;
    }
    return false;
  }

  // The sliver (p, q, r) with its longest side from p to q, and (q, p, d) beyond it, become (r, p, d), (d, q,
  // r). Returns the other triangle, or none where the flip is not possible or no use.
  FaceIndex flip_longest_side(FaceIndex t) {
    const Triangle before = mesh_.triangles[t];
    std::size_t side = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (length(before[i], before[(i + 1) % 3]) > length(before[side], before[(side + 1) % 3])) side = i;
    const FaceIndex other = neighbour_[t][side];
    if (other == none || other == t) return none;
    const VertexIndex p = before[side], q = before[(side + 1) % 3], r = before[(side + 2) % 3];
    const std::size_t back = side_from(other, q);
    const VertexIndex d = mesh_.triangles[other][(back + 2) % 3];
    if (d == r || connected(t, r, d)) return none;
    const std::array<Triangle, 2> after = {{{r, p, d}, {d, q, r}}};
    const bool fewer =
        !is_sliver(other) && !has_no_area(mesh_.points, after[0]) && !has_no_area(mesh_.points, after[1]);
    if (!fewer && !(is_sliver(other) && length(r, d) < length(p, q))) return none;

    const FaceIndex beyond_qr = neighbour_[t][(side + 1) % 3], beyond_rp = neighbour_[t][(side + 2) % 3];
    const FaceIndex beyond_pd = neighbour_[other][(back + 1) % 3],
                    beyond_dq = neighbour_[other][(back + 2) % 3];
    mesh_.triangles[t] = after[0];
    mesh_.triangles[other] = after[1];
    neighbour_[t] = {beyond_rp, beyond_pd, other};
    neighbour_[other] = {beyond_dq, beyond_qr, t};
    if (beyond_pd != none) neighbour_[beyond_pd][side_from(beyond_pd, d)] = t;
    if (beyond_qr != none) neighbour_[beyond_qr][side_from(beyond_qr, r)] = other;
    return other;
  }

  TriangleMesh& mesh_;
  std::vector<std::array<FaceIndex, 3>> neighbour_;  // beyond the side from corner i to i + 1
};

}  // namespace

std::size_t flip_slivers(TriangleMesh& mesh) {
  const bool any = std::any_of(mesh.triangles.begin(), mesh.triangles.end(),
                               [&](const Triangle& t) { return has_no_area(mesh.points, t); });
  return any ? Flipper(mesh).flip() : 0;
}

}  // namespace nanocarbon::mesh
