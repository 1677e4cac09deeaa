// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/surface_fit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace nanocarbon::annealing {

namespace {

constexpr int rounds = 8;
constexpr double least_scale = 0.9, largest_scale = 1.1;
// Motions are left out whose mean square change of height, for atoms that move by one unit in the mean, is
// below this: they are symmetries of the surface.
constexpr double least_change = 3e-3;

using Vector7 = Eigen::Matrix<double, 7, 1>;
using Matrix7 = Eigen::Matrix<double, 7, 7>;

}  // namespace

Similarity fit_to_surface(std::span<const Vec3> positions, const TetherSurface& surface, bool with_scale) {
  Similarity fit;
  const auto count = static_cast<double>(positions.size());
  for (const Vec3& p : positions) fit.centre += p / count;
  double radius = 0;
  for (const Vec3& p : positions) radius += (p - fit.centre).norm() / count;
  Similarity best = fit;
  double least = std::numeric_limits<double>::infinity();  // mean square distance under the best
  for (int round = 0;; ++round) {
    double misfit = 0;
    Matrix7 normal_matrix = Matrix7::Zero();
    Vector7 right = Vector7::Zero();
    for (const Vec3& p : positions) {
      const Vec3 x = fit(p), arm = (x - fit.centre) / radius;
      const TangentPlane plane = surface.plane_at(x);
      Vector7 row;
      row << plane.normal, arm.cross(plane.normal), with_scale ? arm.dot(plane.normal) : 0.0;
      if (surface.space().periodic()) row.tail<4>().setZero();
      normal_matrix += row * row.transpose() / count;
      right -= height_above(plane, x) * row / count;
      misfit += (x - plane.point).squaredNorm() / count;
    }
    // Planes are not the surface: near edges and thin parts a step by them may lead away.
    if (!(misfit < least)) break;
    best = fit;
    least = misfit;
    if (round == rounds) break;
    const Eigen::SelfAdjointEigenSolver<Matrix7> modes(normal_matrix);
    Vector7 step = Vector7::Zero();
    for (int m = 0; m < 7; ++m)
      if (modes.eigenvalues()[m] > least_change)
        step += modes.eigenvectors().col(m).dot(right) / modes.eigenvalues()[m] * modes.eigenvectors().col(m);
    const Vec3 turn = step.segment<3>(3) / radius;
    if (turn.norm() > 0)
      fit.turn = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * fit.turn;
    fit.scale = std::clamp(fit.scale * (1 + step[6] / radius), least_scale, largest_scale);
    fit.shift += step.head<3>();
  }
  return best;
}

}  // namespace nanocarbon::annealing
