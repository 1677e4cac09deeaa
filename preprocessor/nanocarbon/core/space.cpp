// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/space.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace nanocarbon {

namespace {

// Images that can be nearer than the rounded one in a skewed cell: its neighbours.
template <class Visit>
void for_neighbour_images(const Cell& cell, Visit visit) {
  const auto steps = [&](int axis) { return cell.periodic[static_cast<std::size_t>(axis)] ? 1 : 0; };
  for (int i = -steps(0); i <= steps(0); ++i)
    for (int j = -steps(1); j <= steps(1); ++j)
      for (int k = -steps(2); k <= steps(2); ++k) visit(image_shift(cell, {i, j, k}));
}

// Of the translations by one cell edge or none in each direction.
double shortest_translation(const Cell& cell) {
  double shortest = std::numeric_limits<double>::infinity();
  for_neighbour_images(cell, [&](const Vec3& shift) {
    if (const double length = shift.norm(); length > 0) shortest = std::min(shortest, length);
  });
  return shortest;
}

}  // namespace

Space::Space(const Cell& cell) {
  if (!cell.periodic[0] && !cell.periodic[1] && !cell.periodic[2]) return;
  cell_ = cell;
  to_fractional_ = cell.vectors.inverse();
  const Vec3 distances = face_distances(cell);
  least_width_ = shortest_translation(cell);
  // Below half the distance of two opposite faces the fractional coordinates are below a half each.
  double safe = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
    if (cell.periodic[static_cast<std::size_t>(axis)]) safe = std::min(safe, 0.5 * distances[axis]);
  safe_squared_ = safe * safe;
}

Vec3 Space::nearest_image(const Vec3& difference) const {
  Vec3 fractional = to_fractional_ * difference;
  for (int axis = 0; axis < 3; ++axis)
    fractional[axis] = cell_->periodic[static_cast<std::size_t>(axis)] ? std::round(fractional[axis]) : 0.0;
  const Vec3 rounded = difference - cell_->vectors * fractional;
  if (rounded.squaredNorm() < safe_squared_) return rounded;
  Vec3 best = rounded;
  for_neighbour_images(*cell_, [&](const Vec3& shift) {
    if (const Vec3 other = rounded + shift; other.squaredNorm() < best.squaredNorm()) best = other;
  });
  return best;
}

Space Space::scaled(double factor) const {
  if (!cell_) return {};
  Cell cell = *cell_;
  cell.vectors *= factor;
  cell.origin *= factor;
  return Space(cell);
}

}  // namespace nanocarbon
