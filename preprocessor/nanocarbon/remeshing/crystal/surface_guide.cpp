// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/crystal/surface_guide.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace nanocarbon::crystal {
namespace {

//! Splits edges at their midpoints, the longest first, until none is longer than the limit.
TriangleMesh split_long_edges(const TriangleMesh& surface, double limit) {
  CornerTable table(surface);
  std::vector<Vec3> points = surface.points;
  const auto length = [&](HalfEdgeIndex h) {
    return surface.space.displacement(points[table.origin(h)], points[table.target(h)]).norm();
  };
  double longest = 0;
  for (HalfEdgeIndex h = 0; h < table.half_edges(); ++h) longest = std::max(longest, length(h));
  while (longest > limit) {
    const double threshold = std::max(limit, 0.75 * longest);
    longest = 0;
    for (HalfEdgeIndex h = 0; h < table.half_edges(); ++h) {
      if (length(h) > threshold) {
        const Vec3 from = points[table.origin(h)];
        points.push_back(0.5 * (from + surface.space.beside(points[table.target(h)], from)));
        table.split(h);
      }
      longest = std::max(longest, length(h));
    }
  }
  return {std::move(points), table.triangles(), surface.space};
}

//! Normals weighted by the angle of each triangle at the vertex (Baerentzen and Aanaes 2005).
std::vector<Vec3> angle_weighted_normals(const TriangleMesh& mesh) {
  std::vector<Vec3> normals(mesh.points.size(), Vec3::Zero());
  for (const Triangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const Vec3 u = mesh.space.displacement(mesh.points[t[k]], mesh.points[t[(k + 1) % 3]]);
      const Vec3 w = mesh.space.displacement(mesh.points[t[k]], mesh.points[t[(k + 2) % 3]]);
      const Vec3 cross = u.cross(w);
      const double size = cross.norm();
      if (size > 0) normals[t[k]] += std::atan2(size, u.dot(w)) / size * cross;
    }
  for (Vec3& n : normals) n = n.squaredNorm() > 0 ? n.normalized() : Vec3::UnitZ();
  return normals;
}

}  // namespace

SurfaceGuide::SurfaceGuide(const TriangleMesh& surface, double spacing)
    : mesh_(split_long_edges(surface, spacing)),
      table_(mesh_),
      exact_normals_(angle_weighted_normals(mesh_)),
      normals_(exact_normals_),
      boundary_in_(mesh_.points.size(), no_half_edge),
      tree_(std::make_unique<Tree>()) {
  double sum = 0;
  for (HalfEdgeIndex h = 0; h < table_.half_edges(); ++h) {
    sum += mesh_.space.displacement(at(h), at(CornerTable::next(h))).norm();
    if (table_.twin(h) == no_half_edge) boundary_in_[table_.target(h)] = h;
  }
  mean_edge_ = sum / static_cast<double>(table_.half_edges());
}

void SurfaceGuide::smooth_normals(double length) {
  normals_ = exact_normals_;
  // Each round spreads a normal by about one edge; distances add in squares.
  const double rounds = std::min(60.0, std::round(std::pow(length / mean_edge_, 2)));
  for (int round = 0; round < static_cast<int>(rounds); ++round) {
    std::vector<Vec3> smoother = normals_;
    for (const Triangle& t : mesh_.triangles)
      for (int k = 0; k < 3; ++k)
        smoother[t[k]] += 0.5 * (normals_[t[(k + 1) % 3]] + normals_[t[(k + 2) % 3]]);
    for (VertexIndex v = 0; v < smoother.size(); ++v)
      normals_[v] = smoother[v].squaredNorm() > 1e-12 ? smoother[v].normalized() : exact_normals_[v];
  }
}

Foot SurfaceGuide::closest_on(const Vec3& p, std::uint32_t triangle) const {
  const Triangle& t = mesh_.triangles[triangle];
  const Vec3 a = mesh_.space.beside(mesh_.points[t[0]], p), b = mesh_.space.beside(mesh_.points[t[1]], a),
             c = mesh_.space.beside(mesh_.points[t[2]], a);
  const auto w = mesh::nearest_weights(p, a, b, c);
  return {w[0] * a + w[1] * b + w[2] * c, w, triangle};
}

Foot SurfaceGuide::follow(const Vec3& p, std::uint32_t triangle) const {
  Foot best = closest_on(p, triangle);
  double distance = (p - best.point).squaredNorm();
  const auto improve = [&](std::uint32_t candidate) {
    const Foot foot = closest_on(p, candidate);
    const double d = (p - foot.point).squaredNorm();
    if (d >= distance * (1 - 1e-12)) return false;
    best = foot;
    distance = d;
    return true;
  };
  for (bool moved = true; moved;) {
    moved = false;
    const HalfEdgeIndex first = 3 * best.triangle;
    const auto& w = best.weights;
    const int zeros = (w[0] <= 0) + (w[1] <= 0) + (w[2] <= 0);
    if (zeros == 1) {
      const int opposite = w[0] <= 0 ? 0 : w[1] <= 0 ? 1 : 2;
      const HalfEdgeIndex across = table_.twin(first + static_cast<HalfEdgeIndex>((opposite + 1) % 3));
      moved = across != no_half_edge && improve(across / 3);
    } else if (zeros == 2) {
      const int corner = w[0] > 0 ? 0 : w[1] > 0 ? 1 : 2;
      const std::uint32_t here = best.triangle;
      table_.for_outgoing(table_.origin(first + static_cast<HalfEdgeIndex>(corner)), [&](HalfEdgeIndex h) {
        if (h / 3 != here) moved = improve(h / 3) || moved;
      });
    }
  }
  return best;
}

Foot SurfaceGuide::nearest(const Vec3& p) const {
  std::call_once(tree_->built, [&] { tree_->search.emplace(mesh_); });
  return closest_on(p, tree_->search->nearest(p).triangle);
}

Foot SurfaceGuide::nearest(const Vec3& p, const Vec3& facing, std::uint32_t triangle) const {
  const Foot foot = nearest(p);
  return normal(foot).dot(facing) > 0.1 ? foot : follow(p, triangle);
}

BoundaryFoot SurfaceGuide::follow_boundary(const Vec3& p, HalfEdgeIndex edge) const {
  BoundaryFoot best;
  double distance = std::numeric_limits<double>::infinity();
  const auto improve = [&](HalfEdgeIndex h) {
    const Vec3 a = mesh_.space.beside(at(h), p), b = mesh_.space.beside(at(CornerTable::next(h)), a);
    const double t = std::clamp((p - a).dot(b - a) / std::max((b - a).squaredNorm(), 1e-300), 0.0, 1.0);
    const Vec3 q = a + t * (b - a);
    const double d = (p - q).squaredNorm();
    if (d >= distance * (1 - 1e-12)) return false;
    distance = d;
    best = {q, h};
    return true;
  };
  improve(edge);
  while (improve(table_.outgoing(table_.target(best.edge))) ||
         improve(boundary_in_[table_.origin(best.edge)])) {
  }
  return best;
}

Vec3 SurfaceGuide::normal(const Foot& foot) const {
  const Triangle& t = mesh_.triangles[foot.triangle];
  const Vec3 n =
      foot.weights[0] * normals_[t[0]] + foot.weights[1] * normals_[t[1]] + foot.weights[2] * normals_[t[2]];
  const double size = n.norm();
  return size > 1e-6 ? Vec3(n / size) : normals_[t[0]];
}

Vec3 SurfaceGuide::boundary_direction(const BoundaryFoot& foot) const {
  return mesh_.space.displacement(at(foot.edge), at(CornerTable::next(foot.edge))).normalized();
}

Vec3 SurfaceGuide::boundary_normal(const BoundaryFoot& foot) const {
  return (normals_[table_.origin(foot.edge)] + normals_[table_.target(foot.edge)]).normalized();
}

}  // namespace nanocarbon::crystal
