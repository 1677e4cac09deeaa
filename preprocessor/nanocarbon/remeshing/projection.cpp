#include "nanocarbon/remeshing/projection.h"

#include <algorithm>
#include <array>
#include <limits>
#include <nanoflann.hpp>
#include <vector>

#include "nanocarbon/mesh/nearest_point.h"
#include "nanocarbon/remeshing/vertex_stars.h"

namespace nanocarbon {
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
  }

  TriangleMesh mesh;
  PointSet set;
  Tree tree;
  std::vector<std::uint32_t> offsets;  // triangles around vertex v are incident[offsets[v] .. offsets[v + 1])
  std::vector<std::uint32_t> incident;
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
  // A triangle of several of the vertices is met several times; a short list of those seen saves most of the
  // work.
  std::array<std::uint32_t, 64> seen;
  std::size_t seen_count = 0;
  for (std::size_t k = 0; k < found; ++k)
    for (std::uint32_t i = s.offsets[nearest[k]]; i < s.offsets[nearest[k] + 1]; ++i) {
      const std::uint32_t t = s.incident[i];
      if (std::find(seen.begin(), seen.begin() + seen_count, t) != seen.begin() + seen_count) continue;
      if (seen_count < seen.size()) seen[seen_count++] = t;
      const auto [a, b, c] = s.mesh.triangles[t];
      const Vec3 candidate = nearest_on_triangle(point, s.mesh.points[a], s.mesh.points[b], s.mesh.points[c]);
      const double distance = (candidate - point).squaredNorm();
      if (distance < best_distance) best = candidate, best_distance = distance;
    }
  return best;
}

ProjectionTotals project_points(std::vector<Vec3>& points, const ProjectionMesh& surface,
                                unsigned nearest_vertices) {
  const auto n = static_cast<std::ptrdiff_t>(points.size());
  std::vector<double> moves(points.size());
#pragma omp parallel for schedule(static) if (n > least_points_for_threads)
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

}  // namespace nanocarbon
