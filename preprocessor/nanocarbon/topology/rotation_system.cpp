// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/topology/rotation_system.h"

#include <Eigen/Geometry>
#include <cmath>

namespace nanocarbon::topology {
namespace {

constexpr std::uint32_t none = Skeleton::none;

// The half-edges of an atom that are part of the skeleton: two or three, else none.
struct Star {
  std::array<std::uint32_t, 3> half_edge = {none, none, none};
  std::size_t size = 0;
};

Star star(const EmbeddedGraph& graph, const Skeleton& skeleton, AtomIndex atom) {
  Star s;
  for (std::uint32_t h = graph.offsets[atom]; h < graph.offsets[atom + 1]; ++h)
    if (skeleton.twin[h] != none) s.half_edge[s.size++] = h;
  return s;
}

Vec3 perpendicular(const Vec3& v, const Vec3& unit) { return v - v.dot(unit) * unit; }

// The order in which bonds are stored is taken as counter-clockwise; the normal of three bonds is chosen to
// make that true.
void order_and_normals(const EmbeddedGraph& graph, RotationSystem& r) {
  r.next.assign(graph.ends.size(), none);
  r.previous.assign(graph.ends.size(), none);
  r.normals.assign(graph.atoms(), Vec3::Zero());
  for (AtomIndex a = 0; a < graph.atoms(); ++a) {
    const Star s = star(graph, r.skeleton, a);
    for (std::size_t k = 0; k < s.size; ++k) {
      const std::uint32_t h = s.half_edge[k], after = s.half_edge[(k + 1) % s.size];
      r.next[h] = after;
      r.previous[after] = h;
    }
    if (s.size != 3) continue;
    const Vec3 u = graph.vectors[s.half_edge[0]].normalized(), v = graph.vectors[s.half_edge[1]].normalized(),
               w = graph.vectors[s.half_edge[2]].normalized();
    r.normals[a] = (v - u).cross(w - u).normalized();
  }
}

// Breadth first from the atoms with three bonds; what is never reached is a bare cycle.
void carry_normals(const EmbeddedGraph& graph, RotationSystem& r) {
  std::vector<AtomIndex> queue;
  for (AtomIndex a = 0; a < graph.atoms(); ++a)
    if (r.skeleton.degree[a] == 3) queue.push_back(a);
  std::vector<std::uint8_t> reached(graph.atoms(), 0);
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const AtomIndex from = queue[i];
    for (std::uint32_t h = graph.offsets[from]; h < graph.offsets[from + 1]; ++h) {
      const AtomIndex to = graph.ends[h];
      if (r.skeleton.twin[h] == none || r.skeleton.degree[to] != 2 || reached[to]) continue;
      reached[to] = 1;
      r.normals[to] = perpendicular(r.normals[from], graph.vectors[h].normalized()).normalized();
      queue.push_back(to);
    }
  }
  r.bare_cycle.assign(r.skeleton.components, 0);
  for (AtomIndex a = 0; a < graph.atoms(); ++a)
    if (r.skeleton.degree[a] == 2 && !reached[a]) r.bare_cycle[r.skeleton.component[a]] = 1;
}

}  // namespace

RotationSystem rotation_system(const EmbeddedGraph& graph) {
  RotationSystem r;
  r.skeleton = find_skeleton(graph);
  if (r.skeleton.problem) return r;
  order_and_normals(graph, r);
  carry_normals(graph, r);
  return r;
}

}  // namespace nanocarbon::topology
