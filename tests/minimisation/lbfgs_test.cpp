// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/lbfgs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace nanocarbon::minimisation {
namespace {

// Rosenbrock's valley in x and y of every point: minimum 0 at (1, 1).
double rosenbrock(std::span<const Vec3> points, std::span<Vec3> gradient) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points[i].x(), y = points[i].y(), valley = y - x * x;
    sum += 100 * valley * valley + (1 - x) * (1 - x);
    gradient[i] += Vec3(-400 * x * valley - 2 * (1 - x), 200 * valley, 0);
  }
  return sum;
}

TEST(MinimiseLbfgs, FindsTheEndOfACurvedValley) {
  std::vector<Vec3> points = {Vec3(-1.2, 1, 0), Vec3(2, -1, 0)};
  const LbfgsResult result =
      minimise_lbfgs(points, rosenbrock, {.max_iterations = 2000, .force_tolerance = 1e-9});
  EXPECT_TRUE(result.converged);
  for (const Vec3& p : points) EXPECT_LT((p - Vec3(1, 1, 0)).norm(), 1e-8);
}

TEST(MinimiseLbfgs, NoAtomMovesFartherThanTheStep) {
  std::vector<Vec3> points = {Vec3(50, 0, 0)};
  std::vector<Vec3> path = points;
  const auto stop = [&](int, double, std::span<const Vec3> x) {
    path.push_back(x[0]);
    return false;
  };
  const auto well = [](std::span<const Vec3> x, std::span<Vec3> g) {
    g[0] += x[0];
    return 0.5 * x[0].squaredNorm();
  };
  minimise_lbfgs(points, well, {.max_iterations = 50, .max_step = 0.25, .stop = stop});
  ASSERT_GT(path.size(), 10u);
  for (std::size_t i = 1; i < path.size(); ++i) EXPECT_LE((path[i] - path[i - 1]).norm(), 0.25 * (1 + 1e-12));
}

TEST(MinimiseLbfgs, BacksAwayFromWhereTheEnergyIsUndefined) {
  std::vector<Vec3> points = {Vec3(0.05, 0, 0)};
  const auto barrier = [](std::span<const Vec3> x,
                          std::span<Vec3> g) {  // x - log x: minimum at 1, nothing below 0
    const double at = x[0].x();
    g[0].x() += 1 - 1 / at;
    return at > 0 ? at - std::log(at) : std::numeric_limits<double>::quiet_NaN();
  };
  const LbfgsResult result = minimise_lbfgs(points, barrier, {.force_tolerance = 1e-8, .max_step = 5});
  EXPECT_TRUE(result.converged);
  EXPECT_NEAR(points[0].x(), 1, 1e-7);
}

TEST(MinimiseLbfgs, StopsWhenAsked) {
  std::vector<Vec3> points = {Vec3(-1.2, 1, 0)};
  const auto third = [](int iteration, double, std::span<const Vec3>) { return iteration == 3; };
  EXPECT_EQ(minimise_lbfgs(points, rosenbrock, {.stop = third}).iterations, 3);
}

}  // namespace
}  // namespace nanocarbon::minimisation
