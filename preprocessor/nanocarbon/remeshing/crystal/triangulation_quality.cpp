// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/crystal/triangulation_quality.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "nanocarbon/mesh/nearest_point.h"
#include "nanocarbon/remeshing/crystal/corner_table.h"

namespace nanocarbon::crystal {
namespace {

Vec3 centroid(const TriangleMesh& mesh, std::size_t t) {
  const auto [a, b, c] = corners_of(mesh, mesh.triangles[t]);
  return (a + b + c) / 3;
}

Vec3 area_vector(const TriangleMesh& mesh, std::size_t t) {
  const auto [a, b, c] = corners_of(mesh, mesh.triangles[t]);
  return (b - a).cross(c - a);
}

struct Spread {
  double sum = 0, squares = 0, least = 1e300, most = 0;
  std::size_t count = 0;
  void add(double x) {
    sum += x;
    squares += x * x;
    least = std::min(least, x);
    most = std::max(most, x);
    ++count;
  }
  double mean() const { return count ? sum / static_cast<double>(count) : 0; }
  double cv() const {
    const double m = mean();
    return m > 0 ? std::sqrt(std::max(squares / static_cast<double>(count) - m * m, 0.0)) / m : 0;
  }
};

}  // namespace

TriangulationQuality measure_triangulation(const TriangleMesh& triangulation, const TriangleMesh& surface) {
  const CornerTable table(triangulation);
  TriangulationQuality quality;
  quality.vertices = table.live_vertices();
  quality.faces = triangulation.triangles.size();
  for (VertexIndex v = 0; v < table.vertices(); ++v) {
    if (!table.vertex_alive(v) || table.on_boundary(v)) continue;
    const int charge = std::abs(table.valence(v) - 6);
    quality.defects += charge > 0 ? 1 : 0;
    quality.bad += charge > 1 ? 1 : 0;
    quality.charge += static_cast<std::size_t>(charge);
  }
  Spread edges, bonds, distances;
  for (HalfEdgeIndex h = 0; h < table.half_edges(); ++h) {
    if (!table.is_edge(h)) continue;
    edges.add(triangulation.space
                  .displacement(triangulation.points[table.origin(h)], triangulation.points[table.target(h)])
                  .norm());
    if (table.twin(h) != no_half_edge)
      bonds.add(triangulation.space
                    .displacement(centroid(triangulation, table.twin(h) / 3), centroid(triangulation, h / 3))
                    .norm());
  }
  quality.edge_mean = edges.mean();
  quality.edge_cv = edges.cv();
  quality.bond_cv = bonds.cv();
  quality.bond_min = bonds.least / bonds.mean();
  quality.bond_max = bonds.most / bonds.mean();
  const mesh::NearestPoint tree(surface);
  for (const Vec3& p : triangulation.points) distances.add(tree.nearest(p).distance);
  for (std::size_t t = 0; t < quality.faces; ++t) {
    const auto foot = tree.nearest(centroid(triangulation, t));
    distances.add(foot.distance);
    const Vec3 here = area_vector(triangulation, t), there = area_vector(surface, foot.triangle);
    if (here.dot(there) < -0.5 * here.norm() * there.norm()) ++quality.folds;
  }
  quality.distance_mean = distances.mean() / quality.edge_mean;
  quality.distance_max = distances.most / quality.edge_mean;
  return quality;
}

}  // namespace nanocarbon::crystal
