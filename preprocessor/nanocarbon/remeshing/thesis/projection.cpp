// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/projection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>
#include <vector>

#include "nanocarbon/mesh/nearest_point.h"
#include "nanocarbon/remeshing/thesis/vertex_stars.h"

namespace nanocarbon::thesis {
namespace {

constexpr unsigned max_nearest = 32;

//! What nanoflann asks of a set of points.
struct PointSet {
  const std::vector<Vec3>& points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t d) const { return points[i][static_cast<Eigen::Index>(d)]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointSet>, PointSet, 3,
                                                 VertexIndex>;

}  // namespace

struct ProjectionMesh::Search {
  explicit Search(TriangleMesh m)
      : mesh(std::move(m)), set{mesh.points}, tree(3, set, nanoflann::KDTreeSingleIndexAdaptorParams(10)) {
    offsets.assign(mesh.points.size() + 1, 0);
    for (const Triangle& t : mesh.triangles)
      for (const VertexIndex v : t) ++offsets[v + 1];
    for (std::size_t v = 0; v < mesh.points.size(); ++v) offsets[v + 1] += offsets[v];
    incident.resize(3 * mesh.triangles.size());
    std::vector<std::uint32_t> fill(offsets.begin(), offsets.end() - 1);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (const VertexIndex v : mesh.triangles[t]) incident[fill[v]++] = static_cast<std::uint32_t>(t);
    spheres.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::array<Vec3, 3> corners = {mesh.points[a], mesh.points[b], mesh.points[c]};
      Sphere sphere{(corners[0] + corners[1] + corners[2]) / 3.0, 0.0};
      for (const Vec3& corner : corners)
        sphere.radius = std::max(sphere.radius, (corner - sphere.centre).norm());
      spheres.push_back(sphere);
    }
  }

  struct Sphere {
    Vec3 centre;
    double radius;
  };

  TriangleMesh mesh;
  PointSet set;
  Tree tree;
  std::vector<std::uint32_t> offsets;  // triangles around vertex v are incident[offsets[v] .. offsets[v + 1])
  std::vector<std::uint32_t> incident;
  std::vector<Sphere> spheres;  // around each triangle
};

ProjectionMesh::ProjectionMesh(TriangleMesh mesh) : search_(std::make_unique<Search>(std::move(mesh))) {}
ProjectionMesh::~ProjectionMesh() = default;
ProjectionMesh::ProjectionMesh(ProjectionMesh&&) noexcept = default;
ProjectionMesh& ProjectionMesh::operator=(ProjectionMesh&&) noexcept = default;

Vec3 ProjectionMesh::project(const Vec3& point, unsigned nearest_vertices) const {
  const Search& s = *search_;
  std::array<VertexIndex, max_nearest> nearest;
  std::array<double, max_nearest> distances;
  const auto found = s.tree.knnSearch(point.data(), std::clamp(nearest_vertices, 1u, max_nearest),
                                      nearest.data(), distances.data());
  Vec3 best = point;
  double best_distance = std::numeric_limits<double>::infinity();
  double best_length = best_distance;
  for (std::size_t k = 0; k < found; ++k)
    for (std::uint32_t i = s.offsets[nearest[k]]; i < s.offsets[nearest[k] + 1]; ++i) {
      const std::uint32_t t = s.incident[i];
      // Most triangles lie, with the sphere around them, beyond the best candidate; so do not look at them
      // closely.
      const double reach = best_length + s.spheres[t].radius;
      if ((s.spheres[t].centre - point).squaredNorm() > reach * reach) continue;
      const auto [a, b, c] = s.mesh.triangles[t];
      const Vec3 candidate =
          mesh::nearest_on_triangle(point, s.mesh.points[a], s.mesh.points[b], s.mesh.points[c]);
      const double distance = (candidate - point).squaredNorm();
      if (distance >= best_distance) continue;
      best = candidate;
      best_distance = distance;
      best_length = std::sqrt(distance);
    }
  return best;
}

ProjectionTotals project_points(std::vector<Vec3>& points, const ProjectionMesh& surface,
                                unsigned nearest_vertices, unsigned threads) {
  const auto n = static_cast<std::ptrdiff_t>(points.size());
  std::vector<double> moves(points.size());
#pragma omp parallel for schedule(static) num_threads(n > least_points_for_threads ? threads : 1)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const auto v = static_cast<std::size_t>(i);
    const Vec3 projected = surface.project(points[v], nearest_vertices);
    moves[v] = (projected - points[v]).norm();
    points[v] = projected;
  }
  ProjectionTotals totals;
  for (const double move : moves) {
    totals.mean_move += move;
    totals.max_move = std::max(totals.max_move, move);
  }
  if (n > 0) totals.mean_move /= static_cast<double>(n);
  return totals;
}

}  // namespace nanocarbon::thesis
