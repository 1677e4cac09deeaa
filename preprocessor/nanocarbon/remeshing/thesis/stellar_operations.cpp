// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/stellar_operations.h"

#include <Eigen/Geometry>

namespace nanocarbon::thesis {
namespace {

Vec3 area_vector(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a); }

//! Whether two area vectors point apart by more than the limit allows. A face without area has no normal to
//! turn, but none may lose its normal.
bool turned(const Vec3& before, const Vec3& after, double min_cosine) {
  const double norm_before = before.norm();
  if (norm_before == 0.0) return false;
  const double norm_after = after.norm();
  return !(before.dot(after) >= min_cosine * norm_before * norm_after) || norm_after <= 1e-6 * norm_before;
}

bool adjacent(const Triangulation& mesh, VertexHandle a, VertexHandle b) {
  for (const HalfedgeHandle h : mesh.voh_range(a))
    if (mesh.to_vertex_handle(h) == b) return true;
  return false;
}

//! The vertices next to both ends of an edge must be those opposite to it, one for each of its faces.
bool link_condition(const Triangulation& mesh, HalfedgeHandle h) {
  const VertexHandle a = mesh.from_vertex_handle(h), b = mesh.to_vertex_handle(h);
  unsigned common = 0;
  for (const VertexHandle v : mesh.vv_range(a))
    if (v != b && adjacent(mesh, v, b)) ++common;
  const HalfedgeHandle o = mesh.opposite_halfedge_handle(h);
  const unsigned faces = !mesh.is_boundary(h) + !mesh.is_boundary(o);
  if (common != faces) return false;
  if (faces == 2) {
    const bool a_on_boundary = mesh.is_boundary(a), b_on_boundary = mesh.is_boundary(b);
    if (a_on_boundary && b_on_boundary) return false;
    // The links also meet in an edge where both ends have three neighbours only: a tetrahedron.
    return mesh.valence(a) > 3 || mesh.valence(b) > 3 || a_on_boundary || b_on_boundary;
  }
  // A boundary edge: its triangle must hang on to the rest of the surface, or else an edge without faces is
  // left.
  const HalfedgeHandle inner = mesh.is_boundary(h) ? o : h;
  const HalfedgeHandle n = mesh.next_halfedge_handle(inner), p = mesh.prev_halfedge_handle(inner);
  return !mesh.is_boundary(mesh.opposite_halfedge_handle(n)) ||
         !mesh.is_boundary(mesh.opposite_halfedge_handle(p));
}

unsigned least_valence(const Triangulation& mesh, VertexHandle v, const StellarLimits& limits) {
  return mesh.is_boundary(v) ? std::min(limits.min_valence, 2u) : limits.min_valence;
}

//! Whether moving `moving` to `position` turns a face around it other than those that also hold `other`.
Refusal ring_refusal(const Triangulation& mesh, VertexHandle moving, VertexHandle other, const Vec3& position,
                     const StellarLimits& limits) {
  for (const HalfedgeHandle h : mesh.voh_range(moving)) {
    const VertexHandle b = mesh.to_vertex_handle(h);
    const Vec3& pb = mesh.point(b);
    if (b != other && (pb - position).norm() > limits.max_edge) return Refusal::edge_too_long;
    if (mesh.is_boundary(h)) continue;
    const VertexHandle c = mesh.to_vertex_handle(mesh.next_halfedge_handle(h));
    if (b == other || c == other) continue;
    const Vec3& pc = mesh.point(c);
    if (turned(area_vector(mesh.point(moving), pb, pc), area_vector(position, pb, pc),
               limits.min_normal_cosine))
      return Refusal::fold_over;
  }
  return Refusal::none;
}

//! The half-edge whose start vanishes in a collapse: a boundary vertex stays.
HalfedgeHandle collapsing_halfedge(const Triangulation& mesh, EdgeHandle edge) {
  const HalfedgeHandle h = mesh.halfedge_handle(edge, 0);
  return mesh.is_boundary(mesh.from_vertex_handle(h)) ? mesh.opposite_halfedge_handle(h) : h;
}

}  // namespace

Refusal collapse_refusal(const Triangulation& mesh, EdgeHandle edge, const StellarLimits& limits) {
  if (mesh.status(edge).deleted()) return Refusal::deleted;
  const HalfedgeHandle h = collapsing_halfedge(mesh, edge);
  const VertexHandle a = mesh.from_vertex_handle(h), b = mesh.to_vertex_handle(h);
  const unsigned valence_a = mesh.valence(a), valence_b = mesh.valence(b);
  unsigned faces = 0;
  for (const HalfedgeHandle side : {h, mesh.opposite_halfedge_handle(h)}) {
    if (mesh.is_boundary(side)) continue;
    ++faces;
    const VertexHandle opposite = mesh.to_vertex_handle(mesh.next_halfedge_handle(side));
    if (mesh.valence(opposite) <= least_valence(mesh, opposite, limits)) return Refusal::valence;
  }
  const unsigned valence = valence_a + valence_b - 2 - faces;
  if (valence < least_valence(mesh, b, limits)) return Refusal::valence;
  if (valence > std::max({limits.max_valence, valence_a, valence_b})) return Refusal::valence;
  if (faces == 2 && mesh.is_boundary(a) && mesh.is_boundary(b)) return Refusal::boundary;
  return link_condition(mesh, h) ? Refusal::none : Refusal::link_condition;
}

StellarOutcome collapse_edge(Triangulation& mesh, EdgeHandle edge, const Vec3& position,
                             const StellarLimits& limits) {
  if (const Refusal r = collapse_refusal(mesh, edge, limits); r != Refusal::none) return {r, VertexHandle()};
  const HalfedgeHandle h = collapsing_halfedge(mesh, edge);
  const VertexHandle a = mesh.from_vertex_handle(h), b = mesh.to_vertex_handle(h);
  for (const auto& [moving, other] : {std::pair(a, b), std::pair(b, a)})
    if (const Refusal r = ring_refusal(mesh, moving, other, position, limits); r != Refusal::none)
      return {r, VertexHandle()};
  mesh.collapse(h);
  mesh.set_point(b, position);
  return {Refusal::none, b};
}

StellarOutcome split_edge(Triangulation& mesh, EdgeHandle edge, const Vec3& position) {
  if (mesh.status(edge).deleted()) return {Refusal::deleted, VertexHandle()};
  const VertexHandle v = mesh.add_vertex(position);
  mesh.split(edge, v);
  return {Refusal::none, v};
}

Refusal flip_refusal(const Triangulation& mesh, EdgeHandle edge, const StellarLimits& limits) {
  if (mesh.status(edge).deleted()) return Refusal::deleted;
  if (mesh.is_boundary(edge)) return Refusal::boundary;
  const HalfedgeHandle h = mesh.halfedge_handle(edge, 0), o = mesh.halfedge_handle(edge, 1);
  const VertexHandle a = mesh.from_vertex_handle(h), b = mesh.to_vertex_handle(h);
  const VertexHandle c = mesh.to_vertex_handle(mesh.next_halfedge_handle(h));
  const VertexHandle d = mesh.to_vertex_handle(mesh.next_halfedge_handle(o));
  for (const VertexHandle v : {a, b})
    if (mesh.valence(v) <= limits.min_valence) return Refusal::valence;
  for (const VertexHandle v : {c, d})
    if (mesh.valence(v) >= limits.max_valence) return Refusal::valence;
  if (c == d || adjacent(mesh, c, d)) return Refusal::link_condition;
  const Vec3 &pa = mesh.point(a), &pb = mesh.point(b), &pc = mesh.point(c), &pd = mesh.point(d);
  if ((pc - pd).norm() > limits.max_edge) return Refusal::edge_too_long;
  const Vec3 before = area_vector(pa, pb, pc) + area_vector(pb, pa, pd);
  const Vec3 first = area_vector(pd, pb, pc), second = area_vector(pc, pa, pd);
  if (turned(before, first, limits.min_normal_cosine) || turned(before, second, limits.min_normal_cosine))
    return Refusal::fold_over;
  return Refusal::none;
}

StellarOutcome flip_edge(Triangulation& mesh, EdgeHandle edge, const StellarLimits& limits) {
  const Refusal r = flip_refusal(mesh, edge, limits);
  if (r == Refusal::none) mesh.flip(edge);
  return {r, VertexHandle()};
}

}  // namespace nanocarbon::thesis
