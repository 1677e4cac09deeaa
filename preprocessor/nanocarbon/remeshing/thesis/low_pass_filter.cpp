// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/low_pass_filter.h"

#include <algorithm>

namespace nanocarbon::thesis {

LowPassResult low_pass_filter(VertexStars& stars, unsigned rings, unsigned threads) {
  const auto n = static_cast<std::ptrdiff_t>(stars.vertices());
  std::vector<Vec3> moves(stars.vertices(), Vec3::Zero());
#pragma omp parallel num_threads(n > least_points_for_threads ? threads : 1)
  {
    RingSearch search(stars);
#pragma omp for schedule(static)
    for (std::ptrdiff_t i = 0; i < n; ++i) {
      const auto v = static_cast<VertexIndex>(i);
      if (stars.on_boundary[v] || stars.of(v).empty()) continue;
      const auto found = search.search({&v, 1}, rings);
      Vec3 sum = Vec3::Zero();
      double weights = 0.0;
      for (unsigned r = 1; r <= rings; ++r)
        for (std::size_t k = search.ring_begin(r); k < search.ring_begin(r + 1); ++k) {
          sum += stars.points[found[k]] / r;
          weights += 1.0 / r;
        }
      const Vec3 move = sum / weights - stars.points[v];
      const Vec3 normal = vertex_normal(stars, v);
      moves[v] = move - move.dot(normal) * normal;
    }
  }
  LowPassResult result;
  std::size_t movable = 0;
  for (std::size_t v = 0; v < stars.vertices(); ++v) {
    if (stars.on_boundary[v] || stars.of(v).empty()) continue;
    stars.points[v] += moves[v];
    const double length = moves[v].norm();
    result.mean_move += length;
    result.max_move = std::max(result.max_move, length);
    ++movable;
  }
  if (movable) result.mean_move /= static_cast<double>(movable);
  return result;
}

}  // namespace nanocarbon::thesis
