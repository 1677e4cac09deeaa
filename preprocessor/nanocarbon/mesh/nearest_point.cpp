// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/nearest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace nanocarbon::mesh {
namespace {

using Weights = std::array<double, 3>;

// The share of b in the point of a segment that is nearest to p.
double nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  const double along = ab.dot(p - a);
  const double whole = ab.squaredNorm();
  if (along <= 0.0 || whole == 0.0) return 0.0;
  return along >= whole ? 1.0 : along / whole;
}

Weights nearest_on_sides(const Vec3& p, const std::array<Vec3, 3>& corners) {
  Weights best{};
  double best_squared = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const double t = nearest_on_segment(p, corners[i], corners[j]);
    const double squared = (corners[i] + t * (corners[j] - corners[i]) - p).squaredNorm();
    if (!(squared < best_squared)) continue;
    best_squared = squared;
    best = {};
    best[i] = 1.0 - t;
    best[j] = t;
  }
  return best;
}

double squared_distance(const BoundingBox& box, const Vec3& p) {
  return (box.low - p).cwiseMax(p - box.high).cwiseMax(0.0).squaredNorm();
}

}  // namespace

Weights nearest_weights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {1.0, 0.0, 0.0};
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return {0.0, 1.0, 0.0};
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return {0.0, 0.0, 1.0};
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  // Inside the three sides; what rounding leaves of a triangle without area is decided by its sides too.
  if (va > 0.0 && vb > 0.0 && vc > 0.0) {
    const double sum = va + vb + vc;
    return {va / sum, vb / sum, vc / sum};
  }
  return nearest_on_sides(p, {a, b, c});
}

Vec3 nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Weights w = nearest_weights(p, a, b, c);
  if (w[1] == 1.0) return b;
  if (w[2] == 1.0) return c;
  return a + w[1] * (b - a) + w[2] * (c - a);
}

NearestPoint::NearestPoint(const TriangleMesh& mesh)
    : space_(mesh.space),
      tree_(triangle_tree(mesh)),
      corners_(mesh.triangles.size()),
      place_of_(mesh.triangles.size()) {
  for (std::uint32_t place = 0; place < corners_.size(); ++place) {
    const std::uint32_t triangle = tree_.triangles[place];
    place_of_[triangle] = place;
    corners_[place] = corners_in_cell(mesh, mesh.triangles[triangle]);
  }
}

SurfacePoint NearestPoint::nearest(const Vec3& query) const {
  SurfacePoint best{Vec3::Zero(), 0, 0.0};
  double best_squared = std::numeric_limits<double>::infinity();
  search_images(query, best, best_squared);
  return best;
}

SurfacePoint NearestPoint::nearest(const Vec3& query, std::uint32_t triangle_nearby) const {
  const Corners& corners = corners_[place_of_[triangle_nearby]];
  const Vec3 a = space_.beside(corners[0], query);
  SurfacePoint best{nearest_on_triangle(query, a, space_.beside(corners[1], a), space_.beside(corners[2], a)),
                    triangle_nearby, 0.0};
  double best_squared = (best.point - query).squaredNorm();
  search_images(query, best, best_squared);
  return best;
}

std::vector<SurfacePoint> NearestPoint::nearest(std::span<const Vec3> queries) const {
  std::vector<SurfacePoint> found;
  found.reserve(queries.size());
  for (const Vec3& query : queries)
    found.push_back(found.empty() ? nearest(query) : nearest(query, found.back().triangle));
  return found;
}

void NearestPoint::search_images(const Vec3& query, SurfacePoint& best, double& best_squared) const {
  if (!space_.periodic()) return search(query, best, best_squared);
  const Vec3 inside = space_.wrapped(query);
  space_.for_images([&](const Vec3& shift) {
    const double before = best_squared;
    search(inside + shift, best, best_squared);
    if (best_squared < before) best.point += query - (inside + shift);
  });
  best.distance = std::sqrt(best_squared);
}

void NearestPoint::search(const Vec3& query, SurfacePoint& best, double& best_squared) const {
  struct Waiting {
    std::uint32_t node;
    double squared;
  };
  std::array<Waiting, TriangleTree::deepest + 1> stack;
  std::size_t height = 0;
  Waiting at = {0, squared_distance(tree_.nodes[0].box, query)};
  while (true) {
    if (at.squared < best_squared) {
      const TriangleTree::Node& node = tree_.nodes[at.node];
      if (!node.leaf()) {
        Waiting near = {node.first, squared_distance(tree_.nodes[node.first].box, query)};
        Waiting far = {node.first + 1, squared_distance(tree_.nodes[node.first + 1].box, query)};
        if (far.squared < near.squared) std::swap(near, far);
        stack[height++] = far;
        at = near;
        continue;
      }
      for (std::uint32_t place = node.first; place < node.first + node.count; ++place) {
        const Corners& corners = corners_[place];
        const Vec3 point = nearest_on_triangle(query, corners[0], corners[1], corners[2]);
        const double squared = (point - query).squaredNorm();
        if (squared < best_squared) {
          best_squared = squared;
          best.point = point;
          best.triangle = tree_.triangles[place];
        }
      }
    }
    if (height == 0) break;
    at = stack[--height];
  }
  best.distance = std::sqrt(best_squared);
}

}  // namespace nanocarbon::mesh
