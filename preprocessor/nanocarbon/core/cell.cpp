// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/cell.h"

#include <Eigen/LU>
#include <cmath>

namespace nanocarbon {

Cell orthogonal_cell(const Vec3& lengths, std::array<bool, 3> periodic) {
  return {lengths.asDiagonal(), Vec3::Zero(), periodic};
}

Vec3 face_distances(const Cell& cell) {
  const Mat3 inverse = cell.vectors.inverse();
  return Vec3(1.0 / inverse.row(0).norm(), 1.0 / inverse.row(1).norm(), 1.0 / inverse.row(2).norm());
}

double volume(const Cell& cell) { return std::abs(cell.vectors.determinant()); }

Vec3 image_shift(const Cell& cell, const std::array<int, 3>& image) {
  return cell.vectors * Vec3(image[0], image[1], image[2]);
}

}  // namespace nanocarbon
