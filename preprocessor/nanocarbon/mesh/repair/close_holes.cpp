// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/close_holes.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
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

// A loop of a mesh in a cell side by side; nothing where it goes round the cell, as the end of a tube does.
std::vector<Vec3> unrolled(const TriangleMesh& mesh, const std::vector<VertexIndex>& loop) {
  std::vector<Vec3> points;
  for (const VertexIndex v : loop)
    points.push_back(points.empty() ? mesh.points[v] : mesh.space.beside(mesh.points[v], points.back()));
  const Vec3 back = mesh.space.beside(points.front(), points.back());
  if ((back - points.front()).norm() > 1e-6 * (1 + mesh.space.least_width())) points.clear();
  return points;
}

std::size_t close_holes_in_cell(TriangleMesh& mesh, double radius) {
  std::size_t closed = 0;
  std::set<std::pair<VertexIndex, VertexIndex>> edges;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  for (const std::vector<VertexIndex>& loop : loops_of(soup_of(mesh))) {
    if (loop.size() < 3 || loop.size() > most_corners) continue;
    PolygonSoup patch;
    patch.points = unrolled(mesh, loop);
    if (patch.points.empty()) continue;
    std::vector<VertexIndex> corners(loop.size());
    std::iota(corners.begin(), corners.end(), 0u);
    if (!(radius_of(patch.points, corners) < radius)) continue;
    patch.corners = corners;
    patch.close_face();
    const std::vector<Triangle> ears = triangulate(patch).mesh.triangles;
    const bool doubles_an_edge = std::any_of(ears.begin(), ears.end(), [&](const Triangle& t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexIndex a = t[k], b = t[(k + 1) % 3];
        if (b != (a + 1) % loop.size() && edges.contains(std::minmax(loop[a], loop[b]))) return true;
      }
      return false;
    });
    const auto centre = static_cast<VertexIndex>(mesh.points.size());
    if (doubles_an_edge) {
      Vec3 sum = Vec3::Zero();
      for (const Vec3& point : patch.points) sum += point;
      mesh.points.push_back(sum / static_cast<double>(loop.size()));
      for (std::size_t k = 0; k < loop.size(); ++k)
        mesh.triangles.push_back({loop[k], loop[(k + 1) % loop.size()], centre});
    } else {
      for (const Triangle& t : ears) mesh.triangles.push_back({loop[t[0]], loop[t[1]], loop[t[2]]});
    }
    ++closed;
  }
  return closed;
}

}  // namespace

std::size_t close_holes(TriangleMesh& mesh, double radius) {
  if (mesh.space.periodic()) return close_holes_in_cell(mesh, radius);
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

std::vector<double> boundary_radii(const TriangleMesh& mesh) {
  std::vector<double> radii;
  for (const std::vector<VertexIndex>& loop : loops_of(soup_of(mesh)))
    radii.push_back(radius_of(mesh.points, loop));
  return radii;
}

}  // namespace nanocarbon::mesh
