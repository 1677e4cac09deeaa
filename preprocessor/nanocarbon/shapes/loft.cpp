// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/shapes/loft.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nanocarbon::shapes {
namespace {

//! The triangles between a loop of `lower` points that start at vertex `first_lower` and the loop above it.
void join(std::vector<Triangle>& triangles, VertexIndex first_lower, std::size_t lower,
          VertexIndex first_upper, std::size_t upper, double upper_start) {
  const auto low = [&](std::size_t i) { return static_cast<VertexIndex>(first_lower + i % lower); };
  const auto up = [&](std::size_t j) { return static_cast<VertexIndex>(first_upper + j % upper); };
  const std::size_t steps_lower = lower > 1 ? lower : 0, steps_upper = upper > 1 ? upper : 0;
  std::size_t i = 0, j = 0;
  while (i < steps_lower || j < steps_upper) {
    // Where the middle of the next step on either loop is, in turns; the lesser one goes first.
    const double at_lower = (static_cast<double>(i) + 0.5) / static_cast<double>(lower);
    const double at_upper = (static_cast<double>(j) + 0.5) / static_cast<double>(upper) + upper_start;
    if (j == steps_upper || (i < steps_lower && at_lower <= at_upper)) {
      triangles.push_back({low(i), low(i + 1), up(j)});
      ++i;
    } else {
      triangles.push_back({low(i), up(j + 1), up(j)});
      ++j;
    }
  }
}

}  // namespace

TriangleMesh loft(const std::vector<Loop>& loops, bool closed) {
  TriangleMesh mesh;
  std::vector<VertexIndex> first;
  for (const Loop& loop : loops) {
    first.push_back(static_cast<VertexIndex>(mesh.points.size()));
    mesh.points.insert(mesh.points.end(), loop.begin(), loop.end());
  }
  for (std::size_t l = 0; l + 1 < loops.size() + (closed ? 1 : 0); ++l) {
    const std::size_t next = (l + 1) % loops.size();
    const auto centre = [](const Loop& loop) {
      Vec3 sum = Vec3::Zero();
      for (const Vec3& p : loop) sum += p;
      return Vec3(sum / static_cast<double>(loop.size()));
    };
    // How far the upper loop's first point is turned from the lower one's, from the points themselves.
    double start = 0.0;
    if (loops[l].size() > 2 && loops[next].size() > 2) {
      const Vec3 below = centre(loops[l]);
      const Vec3 x = loops[l][0] - below, towards = loops[l][1] - loops[l][0];
      const Vec3 y = (towards - towards.dot(x) / x.squaredNorm() * x).normalized() * x.norm();
      const Vec3 across = loops[next][0] - centre(loops[next]);
      start = std::atan2(across.dot(y), across.dot(x)) / (2.0 * std::numbers::pi);
    }
    join(mesh.triangles, first[l], loops[l].size(), first[next], loops[next].size(), start);
  }
  return mesh;
}

Loop circle(const Vec3& centre, const Vec3& x, const Vec3& y, double radius, double edge, double turn,
            int fewest) {
  const int steps =
      std::max(fewest, static_cast<int>(std::ceil(2.0 * std::numbers::pi * radius / edge - 1e-9)));
  Loop loop;
  for (int i = 0; i < steps; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + turn) / steps;
    loop.push_back(centre + radius * (std::cos(angle) * x + std::sin(angle) * y));
  }
  return loop;
}

}  // namespace nanocarbon::shapes
