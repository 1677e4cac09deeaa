// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/shapes/implicit_surface.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace nanocarbon::shapes {

double capsule_distance(const Vec3& point, const Vec3& from, const Vec3& to, double radius) {
  const Vec3 axis = to - from;
  const double along = std::clamp((point - from).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
  return (point - from - along * axis).norm() - radius;
}

double torus_distance(const Vec3& point, const Vec3& centre, double major, double minor) {
  const Vec3 p = point - centre;
  return std::hypot(std::hypot(p.x(), p.y()) - major, p.z()) - minor;
}

double smooth_union(double a, double b, double blend) {
  const double overlap = std::max(blend - std::abs(a - b), 0.0) / blend;
  return std::min(a, b) - 0.25 * blend * overlap * overlap;
}

Vec3 gradient(const ImplicitShape& shape, const Vec3& point, double step) {
  Vec3 result;
  for (int d = 0; d < 3; ++d) {
    const Vec3 offset = step * Vec3::Unit(d);
    result[d] = (shape(point + offset) - shape(point - offset)) / (2.0 * step);
  }
  return result;
}

}  // namespace nanocarbon::shapes
