// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/crystal/flips.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "nanocarbon/core/chunks.h"
#include "nanocarbon/remeshing/crystal/soundness.h"

namespace nanocarbon::crystal {
namespace {

//! Cotangent of the angle at c in triangle (a, b, c).
double cotangent(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = a - c, w = b - c;
  return u.dot(w) /
         std::max(std::sqrt(std::max(u.squaredNorm() * w.squaredNorm() - std::pow(u.dot(w), 2), 0.0)),
                  1e-300);
}

double largest_cosine(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double x = (b - c).squaredNorm(), y = (c - a).squaredNorm(), z = (a - b).squaredNorm();
  const auto cosine = [](double opposite, double p, double q) {
    return (p + q - opposite) / (2 * std::sqrt(p * q));
  };
  return std::max({cosine(x, y, z), cosine(y, z, x), cosine(z, x, y)});
}

int square(int x) { return x * x; }

//! Change of the sum of (valence - ideal)^2.
int valence_gain(const CornerTable& table, HalfEdgeIndex h) {
  const auto excess = [&](VertexIndex v) { return table.valence(v) - ideal_valence(table, v); };
  const int a = excess(table.origin(h)), b = excess(table.target(h));
  const int c = excess(table.apex(h)), d = excess(table.apex(table.twin(h)));
  return square(a - 1) - square(a) + square(b - 1) - square(b) + square(c + 1) - square(c) + square(d + 1) -
         square(d);
}

//! Whether the angles opposite to an inner edge sum to more than pi.
bool opposite_angles_are_wide(const Tiling& tiling, HalfEdgeIndex h) {
  const CornerTable& table = tiling.table;
  const auto& p = tiling.points;
  const Vec3& a = p[table.origin(h)];
  const auto beside = [&](VertexIndex v) { return tiling.space().beside(p[v], a); };
  const Vec3 b = beside(table.target(h)), c = beside(table.apex(h)), d = beside(table.apex(table.twin(h)));
  if ((a - c).dot(b - c) >= 0 && (a - d).dot(b - d) >= 0) return false;
  return cotangent(a, b, c) + cotangent(a, b, d) < -1e-6;
}

bool is_inner_edge(const CornerTable& table, HalfEdgeIndex h) {
  return table.is_edge(h) && table.twin(h) != no_half_edge;
}

}  // namespace

// As going through all half-edges in order, pass by pass, but only those are looked at that can have wide angles:
// those that have them at the start, and sides of triangles that a flip made.
std::size_t flip_to_delaunay(Tiling& tiling, int passes) {
  CornerTable& table = tiling.table;
  std::vector<std::vector<HalfEdgeIndex>> found(chunks_of(table.half_edges()));
  for_chunks(tiling.team, table.half_edges(), [&](std::size_t begin, std::size_t end) {
    for (auto h = static_cast<HalfEdgeIndex>(begin); h < end; ++h)
      if (is_inner_edge(table, h) && opposite_angles_are_wide(tiling, h))
        found[begin / chunk_size].push_back(h);
  });
  std::set<HalfEdgeIndex> candidates;
  for (const std::vector<HalfEdgeIndex>& list : found) candidates.insert(list.begin(), list.end());
  std::size_t flips = 0;
  for (int pass = 0; pass < passes && !candidates.empty(); ++pass) {
    std::size_t made = 0;
    for (auto next = candidates.begin(); next != candidates.end(); ++next) {
      const HalfEdgeIndex h = *next;
      if (!is_inner_edge(table, h) || !opposite_angles_are_wide(tiling, h) || !flip_is_sound(tiling, h))
        continue;
      const HalfEdgeIndex o = table.twin(h);
      table.flip(h);
      ++made;
      for (const HalfEdgeIndex first : {h - h % 3, o - o % 3})
        for (HalfEdgeIndex k = first; k < first + 3; ++k) {
          candidates.insert(k);
          if (table.twin(k) != no_half_edge) candidates.insert(table.twin(k));
        }
    }
    flips += made;
    if (made == 0) break;
  }
  return flips;
}

std::size_t flip_to_valences(Tiling& tiling, int passes, double shape_limit) {
  CornerTable& table = tiling.table;
  const auto& p = tiling.points;
  std::size_t flips = 0;
  for (int pass = 0; pass < passes; ++pass) {
    std::size_t made = 0;
    for (HalfEdgeIndex h = 0; h < table.half_edges(); ++h) {
      if (!table.is_edge(h) || table.twin(h) == no_half_edge || valence_gain(table, h) >= 0) continue;
      const VertexIndex a = table.origin(h), b = table.target(h), c = table.apex(h),
                        d = table.apex(table.twin(h));
      const auto at = [&](VertexIndex v) { return tiling.space().beside(p[v], p[a]); };
      if (largest_cosine(at(a), at(d), at(c)) > shape_limit ||
          largest_cosine(at(b), at(c), at(d)) > shape_limit)
        continue;
      if (!flip_is_sound(tiling, h)) continue;
      table.flip(h);
      ++made;
    }
    flips += made;
    if (made == 0) break;
  }
  return flips;
}

}  // namespace nanocarbon::crystal
