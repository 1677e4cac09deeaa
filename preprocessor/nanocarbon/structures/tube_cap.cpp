// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "nanocarbon/core/error.h"
#include "nanocarbon/structures/capped_tube.h"

namespace nanocarbon::structures {
namespace {

//! Lattice points closest to a fifth of the circumference, nearest first.
std::vector<shapes::Eisenstein> spokes_near_a_fifth(shapes::Eisenstein circumference) {
  const auto distance = [&](shapes::Eisenstein q) {
    return shapes::norm(shapes::Eisenstein{5 * q.x - circumference.x, 5 * q.y - circumference.y});
  };
  const shapes::Eisenstein about = {std::llround(static_cast<double>(circumference.x) / 5.0),
                                    std::llround(static_cast<double>(circumference.y) / 5.0)};
  std::vector<shapes::Eisenstein> spokes;
  for (std::int64_t x = -3; x <= 3; ++x)
    for (std::int64_t y = -3; y <= 3; ++y) spokes.push_back({about.x + x, about.y + y});
  std::erase_if(spokes, [&](shapes::Eisenstein q) { return shapes::norm(q) == 0 || distance(q) > 25 * 5; });
  std::stable_sort(spokes.begin(), spokes.end(),
                   [&](shapes::Eisenstein a, shapes::Eisenstein b) { return distance(a) < distance(b); });
  return spokes;
}

//! What a cap costs: the squared sides of its triangles, least where they are alike; more for each two
//! pentagons that are neighbours. Nothing for a cap that cannot be: a triangle of it is flat or turned over,
//! or its rim runs back.
struct Cost {
  std::int64_t total = 0;
  int neighbouring_pentagons = 0;
};
std::optional<Cost> cost_of(const std::array<shapes::Eisenstein, 5>& spoke,
                            shapes::Eisenstein circumference) {
  // As much as rounding off a cap by about one lattice step is worth.
  constexpr int for_neighbours = 20;
  const shapes::Eisenstein around = shapes::conjugate(shapes::sixth_turn(2) * circumference);
  Cost cost;
  for (std::size_t i = 0; i < 5; ++i) {
    const shapes::Eisenstein here = spoke[i], next = shapes::sixth_turn(1) * spoke[(i + 1) % 5];
    const shapes::Eisenstein after = shapes::sixth_turn(2) * spoke[(i + 2) % 5],
                             progress = (next - here) * around;
    if (shapes::cross(here, next) <= 0 || 2 * progress.x + progress.y <= 0) return std::nullopt;
    cost.neighbouring_pentagons +=
        (shapes::norm(here) == 1) + (shapes::norm(next - here) == 1) + (shapes::norm(after - here) == 1);
    cost.total += shapes::norm(here) + shapes::norm(next - here);
  }
  cost.total += for_neighbours * cost.neighbouring_pentagons;
  return cost;
}

}  // namespace

TubeCap tube_cap(int n, int m) {
  const shapes::Eisenstein circumference = {n, m};
  const std::vector<shapes::Eisenstein> choice = spokes_near_a_fifth(circumference);
  TubeCap best;
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (const shapes::Eisenstein a : choice)
    for (const shapes::Eisenstein b : choice)
      for (const shapes::Eisenstein c : choice)
        for (const shapes::Eisenstein d : choice) {
          const shapes::Eisenstein e = circumference - a - b - c - d;
          if (shapes::norm(e) == 0) continue;
          const std::optional<Cost> cost = cost_of({a, b, c, d, e}, circumference);
          if (!cost || cost->total >= least) continue;
          least = cost->total;
          best = {{a, b, c, d, e}, cost->neighbouring_pentagons == 0};
        }
  if (least == std::numeric_limits<std::int64_t>::max())
    throw UserError(Failure::usage,
                    fmt::format("a ({}, {}) tube cannot be capped: it is too thin for six pentagons; tubes "
                                "with n + m of 6 or more can, and (5, 0)",
                                n, m));
  return best;
}

}  // namespace nanocarbon::structures
