// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/shapes/even_out.h"

#include <Eigen/Core>
#include <cmath>

#include "nanocarbon/mesh/edge_table.h"

namespace nanocarbon::shapes {
namespace {

std::vector<bool> on_boundary(const TriangleMesh& mesh) {
  std::vector<bool> result(mesh.points.size(), false);
  const mesh::EdgeTable edges = mesh::edge_table(mesh::soup_of(mesh));
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (edges.uses_of(e).size() == 1) result[edges.low[e]] = result[edges.high[e]] = true;
  return result;
}

}  // namespace

Vec3 onto_surface(const ImplicitSlope& shape, Vec3 point, double edge) {
  for (int step = 0; step < 8; ++step) {
    Vec3 uphill;
    const double height = shape(point, uphill);
    Vec3 move = -height / std::max(uphill.squaredNorm(), 1e-300) * uphill;
    if (move.norm() > 0.5 * edge) move *= 0.5 * edge / move.norm();
    point += move;
    if (move.norm() < 1e-10 * edge) break;
  }
  return point;
}

void even_out(TriangleMesh& mesh, const ImplicitShape& shape, double edge, int rounds) {
  const ImplicitSlope by_differences = [&](const Vec3& point, Vec3& slope) {
    slope = gradient(shape, point, 1e-4 * edge);
    return shape(point);
  };
  even_out(mesh, by_differences, edge, rounds);
}

void even_out(TriangleMesh& mesh, const ImplicitSlope& shape, double edge, int rounds) {
  const std::vector<bool> stays = on_boundary(mesh);
  for (int round = 0; round < rounds; ++round) {
    std::vector<Vec3> sum(mesh.points.size(), Vec3::Zero());
    std::vector<int> count(mesh.points.size(), 0);
    for (const Triangle& t : mesh.triangles)
      for (int c = 0; c < 3; ++c) {
        sum[t[c]] += mesh.space.beside(mesh.points[t[(c + 1) % 3]], mesh.points[t[c]]) +
                     mesh.space.beside(mesh.points[t[(c + 2) % 3]], mesh.points[t[c]]);
        count[t[c]] += 2;
      }
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if (!stays[v] && count[v] > 0) mesh.points[v] = onto_surface(shape, sum[v] / count[v], edge);
  }
}

}  // namespace nanocarbon::shapes
