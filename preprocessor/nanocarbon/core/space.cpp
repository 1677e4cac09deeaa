// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/space.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace nanocarbon {
namespace {

// To the nearest whole number; the library's function is a call for each. What is too large to have a fraction stays.
double rounded(double x) {
  constexpr double no_fraction = 4503599627370496.0;  // 2^52
  if (!(std::abs(x) < no_fraction)) return x;
  return static_cast<double>(static_cast<std::int64_t>(x + std::copysign(0.5, x)));
}

}  // namespace

Space::Space(const Cell& cell) {
  if (!cell.periodic[0] && !cell.periodic[1] && !cell.periodic[2]) return;
  cell_ = cell;
  to_fractional_ = cell.vectors.inverse();
  const Vec3 distances = face_distances(cell);
  for_images([&](const Vec3& shift) {
    if (const double length = shift.norm(); length > 0) least_width_ = std::min(least_width_, length);
  });
  // Below half the distance of two opposite faces the fractional coordinates are below a half each.
  double safe = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
    if (cell.periodic[static_cast<std::size_t>(axis)]) safe = std::min(safe, 0.5 * distances[axis]);
  safe_squared_ = safe * safe;
}

Vec3 Space::nearest_image(const Vec3& difference) const {
  Vec3 fractional = to_fractional_ * difference;
  for (int axis = 0; axis < 3; ++axis)
    fractional[axis] = cell_->periodic[static_cast<std::size_t>(axis)] ? rounded(fractional[axis]) : 0.0;
  const Vec3 near = difference - cell_->vectors * fractional;
  if (near.squaredNorm() < safe_squared_) return near;
  Vec3 best = near;
  // In a skewed cell a neighbour of the rounded image can be nearer.
  for_images([&](const Vec3& shift) {
    if (const Vec3 other = near + shift; other.squaredNorm() < best.squaredNorm()) best = other;
  });
  return best;
}

Vec3 Space::wrapped(const Vec3& point) const {
  if (!cell_) return point;
  Vec3 fractional = to_fractional_ * (point - cell_->origin);
  for (int axis = 0; axis < 3; ++axis)
    fractional[axis] = cell_->periodic[static_cast<std::size_t>(axis)] ? std::floor(fractional[axis]) : 0.0;
  return point - cell_->vectors * fractional;
}

std::array<std::int32_t, 3> Space::image(const Vec3& from, const Vec3& to) const {
  if (!cell_ || is_nearest(from, to)) return {0, 0, 0};
  return multiples(displacement(from, to) - (to - from));
}

std::array<std::int32_t, 3> Space::multiples(const Vec3& translation) const {
  if (!cell_) return {0, 0, 0};
  const Vec3 edges = to_fractional_ * translation;
  return {static_cast<std::int32_t>(std::lround(edges[0])), static_cast<std::int32_t>(std::lround(edges[1])),
          static_cast<std::int32_t>(std::lround(edges[2]))};
}

Space Space::strained(const Mat3& deformation) const {
  if (!cell_) return {};
  Cell cell = *cell_;
  cell.vectors = deformation * cell.vectors;
  cell.origin = deformation * cell.origin;
  return Space(cell);
}

Space Space::scaled(double factor) const {
  if (!cell_) return {};
  Cell cell = *cell_;
  cell.vectors *= factor;
  cell.origin *= factor;
  return Space(cell);
}

}  // namespace nanocarbon
