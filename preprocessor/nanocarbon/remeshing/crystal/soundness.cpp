// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/crystal/soundness.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "nanocarbon/core/chunks.h"

namespace nanocarbon::crystal {
namespace {

// A cap, three corners nearly on a line, must be flipped into its neighbour even where that one is a little
// unsound.
constexpr double flip_tolerance = 0.15;

//! Whether a flip would fold one of the five edges it touches, and more than any of them is folded now.
bool makes_crease(const Tiling& tiling, HalfEdgeIndex h) {
  const CornerTable& table = tiling.table;
  const auto& p = tiling.points;
  const auto normal = [&](VertexIndex x, VertexIndex y, VertexIndex z) {
    return unit_normal(tiling.space(), p[x], p[y], p[z]);
  };
  const HalfEdgeIndex o = table.twin(h);
  const VertexIndex a = table.origin(h), b = table.target(h), c = table.apex(h), d = table.apex(o);
  const Vec3 abc = normal(a, b, c), bad = normal(b, a, d), adc = normal(a, d, c), bcd = normal(b, c, d);
  double before = abc.dot(bad), after = adc.dot(bcd);
  const auto outside = [&](HalfEdgeIndex side, const Vec3& old_inside, const Vec3& new_inside) {
    const HalfEdgeIndex k = table.twin(side);
    if (k == no_half_edge) return;
    const Vec3 n = normal(table.origin(k), table.target(k), table.apex(k));
    before = std::min(before, n.dot(old_inside));
    after = std::min(after, n.dot(new_inside));
  };
  outside(CornerTable::next(h), abc, bcd);
  outside(CornerTable::previous(h), abc, adc);
  outside(CornerTable::next(o), bad, adc);
  outside(CornerTable::previous(o), bad, bcd);
  return after < creased_below - flip_tolerance && after < before;
}

//! Least soundness of the triangle that replaces the one of half-edge k, with `as` in place of origin(k).
double soundness_of(const Tiling& tiling, HalfEdgeIndex k, VertexIndex as) {
  const CornerTable& table = tiling.table;
  const VertexIndex x = table.target(k), y = table.apex(k);
  double least = facing(tiling, as, x, y) - turned_below;
  const HalfEdgeIndex rim = table.twin(CornerTable::next(k));
  if (rim == no_half_edge) return least;
  const auto& p = tiling.points;
  const Space& space = tiling.space();
  const Vec3 outside = unit_normal(space, p[table.origin(rim)], p[table.target(rim)], p[table.apex(rim)]);
  return std::min(least, unit_normal(space, p[as], p[x], p[y]).dot(outside) - creased_below);
}

}  // namespace

Corner corner(const Tiling& tiling, VertexIndex v) {
  return {tiling.points[v], tiling.normals[v],
          tiling.table.on_boundary(v) ? tiling.places[v] / 3 : tiling.places[v]};
}

double facing(const SurfaceGuide& guide, const Corner& a, const Corner& b, const Corner& c) {
  const Space& space = guide.space();
  const Vec3 cross = space.displacement(a.point, b.point).cross(space.displacement(a.point, c.point));
  const double area = cross.norm();
  if (area <= 0) return -1;
  const Vec3 n = a.normal + b.normal + c.normal;
  const double size = n.norm();
  if (size > 1.8) return cross.dot(n) / (area * size);
  const Vec3 middle = (a.point + space.beside(b.point, a.point) + space.beside(c.point, a.point)) / 3;
  return std::min(1.0, cross.dot(guide.normal(guide.follow(middle, a.triangle))) / area + 0.5);
}

double facing(const Tiling& tiling, VertexIndex a, VertexIndex b, VertexIndex c) {
  return facing(*tiling.guide, corner(tiling, a), corner(tiling, b), corner(tiling, c));
}

Vec3 unit_normal(const Space& space, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 cross = space.displacement(a, b).cross(space.displacement(a, c));
  const double size = cross.norm();
  return size > 0 ? Vec3(cross / size) : Vec3(Vec3::Zero());
}

double soundness_around(const Tiling& tiling, VertexIndex v) {
  const CornerTable& table = tiling.table;
  const auto& p = tiling.points;
  double least = 1;
  table.for_outgoing(v, [&](HalfEdgeIndex k) {
    least = std::min(least, soundness_of(tiling, k, v));
    const HalfEdgeIndex o = table.twin(k);
    if (o == no_half_edge) return;
    const Vec3 left = unit_normal(tiling.space(), p[v], p[table.target(k)], p[table.apex(k)]);
    const Vec3 right = unit_normal(tiling.space(), p[v], p[table.apex(o)], p[table.target(k)]);
    least = std::min(least, left.dot(right) - creased_below);
  });
  return least;
}

std::vector<VertexIndex> unsound_vertices(const Tiling& tiling) {
  const std::size_t vertices = tiling.table.vertices();
  std::vector<std::vector<VertexIndex>> found(chunks_of(vertices));
  for_chunks(tiling.team, vertices, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<VertexIndex>(begin); v < end; ++v)
      if (tiling.table.vertex_alive(v) && !tiling.is_held(v) && soundness_around(tiling, v) < 0)
        found[begin / chunk_size].push_back(v);
  });
  std::vector<VertexIndex> all;
  for (const std::vector<VertexIndex>& list : found) all.insert(all.end(), list.begin(), list.end());
  return all;
}

bool flip_is_sound(const Tiling& tiling, HalfEdgeIndex h) {
  const CornerTable& table = tiling.table;
  if (!table.can_flip(h)) return false;
  const HalfEdgeIndex o = table.twin(h);
  const VertexIndex a = table.origin(h), b = table.target(h), c = table.apex(h), d = table.apex(o);
  if (tiling.is_held(a) || tiling.is_held(b) || tiling.is_held(c) || tiling.is_held(d)) return false;
  const int least_a = table.on_boundary(a) ? 3 : 4, least_b = table.on_boundary(b) ? 3 : 4;
  if (table.valence(a) < least_a || table.valence(b) < least_b) return false;
  if (makes_crease(tiling, h)) return false;
  const double after = std::min(facing(tiling, a, d, c), facing(tiling, b, c, d));
  if (after >= turned_below - flip_tolerance) return true;
  return after > std::min(facing(tiling, a, b, c), facing(tiling, b, a, d));
}

bool collapse_is_sound(const Tiling& tiling, HalfEdgeIndex h, double before) {
  const CornerTable& table = tiling.table;
  const VertexIndex a = table.origin(h), b = table.target(h);
  double after = 1;
  for (const VertexIndex v : {a, b})
    table.for_outgoing(v, [&](HalfEdgeIndex k) {
      const VertexIndex other = v == a ? b : a;
      if (table.target(k) != other && table.apex(k) != other)
        after = std::min(after, soundness_of(tiling, k, b));
    });
  return after >= 0 || after >= before;
}

}  // namespace nanocarbon::crystal
