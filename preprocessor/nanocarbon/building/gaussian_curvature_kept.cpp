// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/gaussian_curvature_kept.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/nearest_point.h"

namespace nanocarbon::building {
namespace {

using std::numbers::pi;

// Each round spreads values over a ring or so; distances add in squares.
constexpr int smoothing_rounds = 8;

std::vector<bool> on_boundary(const TriangleMesh& mesh, const mesh::EdgeTable& edges) {
  std::vector<bool> result(mesh.points.size(), false);
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (edges.uses_of(e).size() == 1) result[edges.low[e]] = result[edges.high[e]] = true;
  return result;
}

// Of each vertex the angle that its triangles lack of a full turn. Vertices at the boundary have none: for the area that is
// theirs the others count more.
std::vector<double> missing_angles(const TriangleMesh& mesh) {
  const std::vector<bool> outer = on_boundary(mesh, mesh::edge_table(mesh::soup_of(mesh)));
  std::vector<double> missing(mesh.points.size(), 2 * pi);
  double area = 0, inner_area = 0;
  for (const Triangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const Vec3& p = mesh.points[t[k]];
      const Vec3 u = mesh.space.displacement(p, mesh.points[t[(k + 1) % 3]]);
      const Vec3 v = mesh.space.displacement(p, mesh.points[t[(k + 2) % 3]]);
      const double doubled = u.cross(v).norm();
      missing[t[k]] -= std::atan2(doubled, u.dot(v));
      area += doubled;
      if (!outer[t[k]]) inner_area += doubled;
    }
  for (VertexIndex v = 0; v < missing.size(); ++v) missing[v] = outer[v] ? 0 : missing[v] * area / inner_area;
  return missing;
}

// Values of a surface's vertices, each at the nearest vertex of another mesh.
std::vector<double> carried_over(const std::vector<double>& values, const TriangleMesh& from,
                                 const TriangleMesh& to) {
  std::vector<double> result(to.points.size(), 0.0);
  const std::vector<mesh::SurfacePoint> feet = mesh::NearestPoint(to).nearest(from.points);
  for (VertexIndex v = 0; v < values.size(); ++v) {
    const Triangle& t = to.triangles[feet[v].triangle];
    VertexIndex closest = t[0];
    const auto distance = [&](VertexIndex corner) {
      return to.space.displacement(feet[v].point, to.points[corner]).squaredNorm();
    };
    for (const VertexIndex corner : t)
      if (distance(corner) < distance(closest)) closest = corner;
    result[closest] += values[v];
  }
  return result;
}

std::vector<double> smoothed(std::vector<double> values, const mesh::EdgeTable& edges) {
  for (int round = 0; round < smoothing_rounds; ++round) {
    std::vector<double> next = values;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const double flow = (values[edges.high[e]] - values[edges.low[e]]) / 8;
      next[edges.low[e]] += flow;
      next[edges.high[e]] -= flow;
    }
    values = std::move(next);
  }
  return values;
}

}  // namespace

std::optional<double> gaussian_curvature_kept(const TriangleMesh& triangulation,
                                              const TriangleMesh& surface) {
  const std::vector<double> own = missing_angles(triangulation);
  const std::vector<double> wanted = carried_over(missing_angles(surface), surface, triangulation);
  const std::vector<double> smooth = smoothed(wanted, mesh::edge_table(mesh::soup_of(triangulation)));
  double has = 0, whole = 0;
  for (VertexIndex v = 0; v < own.size(); ++v) {
    has += std::copysign(own[v], own[v] * smooth[v]);
    whole += std::copysign(wanted[v], wanted[v] * smooth[v]);
  }
  if (whole < pi / 3) return {};
  return has / whole;
}

}  // namespace nanocarbon::building
