// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/close_holes.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/triangulate.h"

namespace nanocarbon::mesh {
namespace {

double radius_of(const std::vector<Vec3>& points, const std::vector<VertexIndex>& loop) {
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    length += (points[loop[(i + 1) % loop.size()]] - points[loop[i]]).norm();
  return newell_normal(points, loop).norm() / std::max(length, 1e-300);  // twice the area is its norm
}

// The boundary loops, as the faces that would close them run.
std::vector<std::vector<VertexIndex>> loops_of(const PolygonSoup& soup) {
  constexpr VertexIndex none = std::numeric_limits<VertexIndex>::max();
  std::vector<VertexIndex> next(soup.points.size(), none);
  const EdgeTable edges = edge_table(soup);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.uses_of(e).size() != 1) continue;
    const bool forward = edges.uses_of(e)[0].forward;
    next[forward ? edges.high[e] : edges.low[e]] = forward ? edges.low[e] : edges.high[e];
  }
  std::vector<std::vector<VertexIndex>> loops;
  for (VertexIndex v = 0; v < next.size(); ++v) {
    if (next[v] == none) continue;
    std::vector<VertexIndex>& loop = loops.emplace_back();
    for (VertexIndex at = v; next[at] != none; at = std::exchange(next[at], none)) loop.push_back(at);
  }
  return loops;
}

}  // namespace

std::size_t close_holes(TriangleMesh& mesh, double radius) {
  PolygonSoup soup = soup_of(mesh);
  std::size_t closed = 0;
  for (const std::vector<VertexIndex>& loop : loops_of(soup)) {
    if (loop.size() < 3 || loop.size() > most_corners || !(radius_of(soup.points, loop) < radius)) continue;
    soup.corners.insert(soup.corners.end(), loop.begin(), loop.end());
    soup.close_face();
    ++closed;
  }
  if (closed > 0) mesh = triangulate(soup).mesh;
  return closed;
}

}  // namespace nanocarbon::mesh
