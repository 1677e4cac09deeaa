// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/triangle_intersection.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/orientation.h"

namespace nanocarbon::mesh {
namespace {

struct Corners {
  Vec3 a, b, c;
};

// An axis along which the triangle projects to one with an area, or -1.
int projection_axis(const Corners& t) {
  int axis = 0;
  area_normal(t.a, t.b, t.c).cwiseAbs().maxCoeff(&axis);
  for (int i = 0; i < 3; ++i, axis = (axis + 1) % 3)
    if (orientation_2d(t.a, t.b, t.c, axis) != 0) return axis;
  return -1;
}

bool same_side_or_on(int a, int b, int c) {
  return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

bool holds_2d(const Corners& t, const Vec3& p, int axis) {
  return same_side_or_on(orientation_2d(t.a, t.b, p, axis), orientation_2d(t.b, t.c, p, axis),
                         orientation_2d(t.c, t.a, p, axis));
}

bool on_segment_2d(const Vec3& p, const Vec3& q, const Vec3& r, int axis) {  // r on the line through p and q
  for (const int d : {(axis + 1) % 3, (axis + 2) % 3})
    if (r[d] < std::min(p[d], q[d]) || r[d] > std::max(p[d], q[d])) return false;
  return true;
}

bool segments_meet_2d(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s, int axis) {
  const int pqr = orientation_2d(p, q, r, axis), pqs = orientation_2d(p, q, s, axis);
  const int rsp = orientation_2d(r, s, p, axis), rsq = orientation_2d(r, s, q, axis);
  if (pqr * pqs < 0 && rsp * rsq < 0) return true;
  return (pqr == 0 && on_segment_2d(p, q, r, axis)) || (pqs == 0 && on_segment_2d(p, q, s, axis)) ||
         (rsp == 0 && on_segment_2d(r, s, p, axis)) || (rsq == 0 && on_segment_2d(r, s, q, axis));
}

// Of a segment in the triangle's plane.
bool meets_in_plane(const Vec3& p, const Vec3& q, const Corners& t) {
  const int axis = projection_axis(t);
  if (axis < 0) return false;
  return holds_2d(t, p, axis) || holds_2d(t, q, axis) || segments_meet_2d(p, q, t.a, t.b, axis) ||
         segments_meet_2d(p, q, t.b, t.c, axis) || segments_meet_2d(p, q, t.c, t.a, axis);
}

bool meets(const Vec3& p, const Vec3& q, const Corners& t) {
  const int side_p = orientation(t.a, t.b, t.c, p), side_q = orientation(t.a, t.b, t.c, q);
  if (side_p * side_q > 0) return false;
  if (side_p == 0 && side_q == 0) return meets_in_plane(p, q, t);
  return same_side_or_on(orientation(p, q, t.a, t.b), orientation(p, q, t.b, t.c),
                         orientation(p, q, t.c, t.a));
}

bool all_on_one_side(const Corners& of, const Corners& t) {
  const int a = orientation(of.a, of.b, of.c, t.a);
  return a != 0 && a == orientation(of.a, of.b, of.c, t.b) && a == orientation(of.a, of.b, of.c, t.c);
}

bool sides_meet(const Corners& s, const Corners& t) {
  return meets(s.a, s.b, t) || meets(s.b, s.c, t) || meets(s.c, s.a, t);
}

// Certain, whatever is rounded: from the corner that they share, the triangles go to different sides of a plane.
bool part_at_common_corner(const Corners& s, const Corners& t) {
  const Vec3 sb = s.b - s.a, sc = s.c - s.a, tb = t.b - s.a, tc = t.c - s.a;
  const Vec3 away = sb.normalized() + sc.normalized() - tb.normalized() - tc.normalized();
  const double margin = 1e-9 * away.norm();
  return away.dot(sb) > margin * sb.norm() && away.dot(sc) > margin * sc.norm() &&
         away.dot(tb) < -margin * tb.norm() && away.dot(tc) < -margin * tc.norm();
}

// Certain, too: a plane across the line between their middles parts them.
bool part_across_middles(const Corners& s, const Corners& t) {
  const Vec3 sb = s.b - s.a, sc = s.c - s.a, ta = t.a - s.a, tb = t.b - s.a, tc = t.c - s.a;
  const Vec3 along = ta + tb + tc - sb - sc;
  const double size = std::max({sb.norm(), sc.norm(), ta.norm(), tb.norm(), tc.norm()});
  return std::max({0.0, along.dot(sb), along.dot(sc)}) + 1e-9 * along.norm() * size <
         std::min({along.dot(ta), along.dot(tb), along.dot(tc)});
}

// The triangle's corners, the vertices it shares first. Rotated only, so that it keeps its winding.
int bring_shared_first(Triangle& triangle, const Triangle& other) {
  const auto shared = [&](VertexIndex v) { return std::find(other.begin(), other.end(), v) != other.end(); };
  const auto count = static_cast<int>(std::count_if(triangle.begin(), triangle.end(), shared));
  const bool one = count == 1;
  for (int i = 0; i < 2 && shared(triangle[one ? 0 : 2]) != one; ++i)
    std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
  return count;
}

}  // namespace

bool intersect(const TriangleMesh& mesh, const Triangle& first, const Triangle& second) {
  Triangle one = first, two = second;
  const int shared = bring_shared_first(one, second);
  bring_shared_first(two, first);
  const auto corners = [&](const Triangle& t) {
    return Corners{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
  };
  const Corners s = corners(one), t = corners(two);
  if (projection_axis(s) < 0 || projection_axis(t) < 0) return false;
  if (shared == 0)
    return !part_across_middles(s, t) && !all_on_one_side(s, t) && !all_on_one_side(t, s) &&
           (sides_meet(s, t) || sides_meet(t, s));
  // From the vertex that they share, what they have in common reaches out to the far side of one of them.
  if (shared == 1 && part_at_common_corner(s, t)) return false;
  if (shared == 1) return meets(s.b, s.c, t) || meets(t.b, t.c, s);
  if (shared == 3) return true;
  // With a common edge they meet only when folded flat upon each other.
  const Vec3 along = s.b - s.a;
  const Vec3 one_side = along.cross(s.c - s.a), other_side = along.cross(t.c - s.a);
  const double facing = one_side.dot(other_side);  // below zero for certain: they go to different sides
  if (facing < -1e-9 * one_side.norm() * other_side.norm()) return false;
  if (orientation(s.a, s.b, s.c, t.c) != 0) return false;
  const int axis = projection_axis(s);
  return orientation_2d(s.a, s.b, s.c, axis) == orientation_2d(s.a, s.b, t.c, axis);
}

Crossing crossing(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const int side_p = orientation(a, b, c, p), side_q = orientation(a, b, c, q);
  if (side_p * side_q > 0) return Crossing::none;
  const int ab = orientation(p, q, a, b), bc = orientation(p, q, b, c), ca = orientation(p, q, c, a);
  if (!same_side_or_on(ab, bc, ca)) return Crossing::none;
  return side_p * side_q * ab * bc * ca == 0 ? Crossing::degenerate : Crossing::through;
}

}  // namespace nanocarbon::mesh
