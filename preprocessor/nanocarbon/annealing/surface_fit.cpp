// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/surface_fit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "nanocarbon/core/chunks.h"

namespace nanocarbon::annealing {

namespace {

constexpr int rounds = 8;
constexpr double least_scale = 0.9, largest_scale = 1.1;
// Motions are left out whose mean square change of height, for atoms that move by one unit in the mean, is
// below this: they are symmetries of the surface.
constexpr double least_change = 3e-3;

using Vector7 = Eigen::Matrix<double, 7, 1>;
using Matrix7 = Eigen::Matrix<double, 7, 7>;

// Least squares of the heights above tangent planes, in motions about the centre; means over all atoms.
struct Sums {
  double misfit = 0;  // square of the distance to the nearest point
  Matrix7 normal_matrix = Matrix7::Zero();
  Vector7 right = Vector7::Zero();

  void add(const Vec3& x, const Vec3& arm, const TangentPlane& plane, bool with_scale, bool periodic,
           double count) {
    Vector7 row;
    row << plane.normal, arm.cross(plane.normal), with_scale ? arm.dot(plane.normal) : 0.0;
    if (periodic) row.tail<4>().setZero();
    normal_matrix += row * row.transpose() / count;
    right -= height_above(plane, x) * row / count;
    misfit += (x - plane.point).squaredNorm() / count;
  }
  void operator+=(const Sums& other) {
    misfit += other.misfit;
    normal_matrix += other.normal_matrix;
    right += other.right;
  }
};

}  // namespace

Similarity fit_to_surface(std::span<const Vec3> positions, const TetherSurface& surface, bool with_scale,
                          ThreadTeam* team) {
  Similarity fit;
  const auto count = static_cast<double>(positions.size());
  for (const Vec3& p : positions) fit.centre += p / count;
  double radius = 0;
  for (const Vec3& p : positions) radius += (p - fit.centre).norm() / count;
  Similarity best = fit;
  double least = std::numeric_limits<double>::infinity();  // mean square distance under the best
  for (int round = 0;; ++round) {
    std::vector<Sums> parts(chunks_of(positions.size()));
    for_chunks(team, positions.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t a = begin; a < end; ++a) {
        const Vec3 x = fit(positions[a]);
        parts[begin / chunk_size].add(x, (x - fit.centre) / radius, surface.plane_at(x), with_scale,
                                      surface.space().periodic(), count);
      }
    });
    Sums sums;
    for (const Sums& part : parts) sums += part;
    // Planes are not the surface: near edges and thin parts a step by them may lead away.
    if (!(sums.misfit < least)) break;
    best = fit;
    least = sums.misfit;
    if (round == rounds) break;
    const Eigen::SelfAdjointEigenSolver<Matrix7> modes(sums.normal_matrix);
    Vector7 step = Vector7::Zero();
    for (int m = 0; m < 7; ++m)
      if (modes.eigenvalues()[m] > least_change)
        step += modes.eigenvectors().col(m).dot(sums.right) / modes.eigenvalues()[m] *
                modes.eigenvectors().col(m);
    const Vec3 turn = step.segment<3>(3) / radius;
    if (turn.norm() > 0)
      fit.turn = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * fit.turn;
    fit.scale = std::clamp(fit.scale * (1 + step[6] / radius), least_scale, largest_scale);
    fit.shift += step.head<3>();
  }
  return best;
}

void bring_back(std::span<Vec3> positions, std::span<const Vec3> before, bool turn) {
  constexpr double farther = 1.5, noticed = 0.5;  // Angstrom, the latter
  const auto n = static_cast<Eigen::Index>(before.size());
  const Eigen::Map<const Eigen::Matrix3Xd> now(positions.front().data(), 3, n);
  const Eigen::Map<const Eigen::Matrix3Xd> then(before.front().data(), 3, n);
  Eigen::Isometry3d back = Eigen::Isometry3d::Identity();
  if (turn && n > 2)
    back = Eigen::Isometry3d(Eigen::umeyama(now, then, false));
  else
    back.translation() = (then - now).rowwise().mean();
  const double drifted = (now - then).norm(), left = (back * now - then).norm();
  if (drifted < farther * left || drifted < noticed * std::sqrt(static_cast<double>(n))) return;
  for (Vec3& p : positions) p = back * p;
}

}  // namespace nanocarbon::annealing
