#include "nanocarbon/molecule/rotation_system.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "nanocarbon/molecule/signed_sets.h"

namespace nanocarbon {
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
  r.bare_cycle.assign(r.skeleton.pieces, 0);
  for (AtomIndex a = 0; a < graph.atoms(); ++a)
    if (r.skeleton.degree[a] == 2 && !reached[a]) r.bare_cycle[r.skeleton.piece[a]] = 1;
}

// Cosine of the angle by which a bond is twisted, between the normals of its two atoms seen along it.
double agreement(const Vec3& normal, const Vec3& other, const Vec3& along) {
  const Vec3 unit = along.normalized();
  const Vec3 a = perpendicular(normal, unit), b = perpendicular(other, unit);
  const double product = a.norm() * b.norm();
  return product > 1e-6 ? a.dot(b) / product : 0.0;
}

// Decides twists and, by them, orients the pieces. Bonds that cannot be told come last: one that joins two
// parts may have any twist, since either part may be turned over as a whole.
void orient(const EmbeddedGraph& graph, RotationSystem& r) {
  constexpr double undecided = 0.1;  // cosine; within six degrees of a right angle
  struct Doubtful {
    AtomIndex atom;
    std::uint32_t half_edge;
  };
  r.twisted.assign(graph.ends.size(), 0);
  r.one_sided.assign(r.skeleton.pieces, 0);
  SignedSets sides(graph.atoms());
  std::vector<Doubtful> doubtful;
  for (AtomIndex a = 0; a < graph.atoms(); ++a)
    for (std::uint32_t h = graph.offsets[a]; h < graph.offsets[a + 1]; ++h) {
      const std::uint32_t back = r.skeleton.twin[h];
      if (back == none || back < h || r.bare_cycle[r.skeleton.piece[a]]) continue;
      const double cosine = agreement(r.normals[a], r.normals[graph.ends[h]], graph.vectors[h]);
      if (std::abs(cosine) < undecided) {
        doubtful.push_back({a, h});
        continue;
      }
      r.twisted[h] = r.twisted[back] = cosine < 0.0;
      if (!sides.join(a, graph.ends[h], cosine < 0.0)) r.one_sided[r.skeleton.piece[a]] = 1;
    }
  for (const auto& [a, h] : doubtful) {
    const AtomIndex end = graph.ends[h];
    if (sides.find(a).root == sides.find(end).root) {
      r.skeleton.problem =
          NotASurface{fmt::format("the bond of atom ID {} with atom ID {} is twisted by a right "
                                  "angle, so that its sides cannot be told",
                                  graph.id(a), graph.id(end)),
                      a};
      return;
    }
    sides.join(a, end);
  }
  r.flipped.resize(graph.atoms());
  for (AtomIndex a = 0; a < graph.atoms(); ++a) r.flipped[a] = sides.find(a).opposite;
}

// Turns over pieces whose normals point inwards: on the whole, a surface bends away from its outer normal.
void point_outwards(const EmbeddedGraph& graph, RotationSystem& r) {
  std::vector<double> bending(r.skeleton.pieces, 0.0);
  for (AtomIndex a = 0; a < graph.atoms(); ++a) {
    const Vec3 normal = r.flipped[a] ? Vec3(-r.normals[a]) : r.normals[a];
    for (std::uint32_t h = graph.offsets[a]; h < graph.offsets[a + 1]; ++h)
      if (r.skeleton.twin[h] != none) bending[r.skeleton.piece[a]] += normal.dot(graph.vectors[h]);
  }
  for (AtomIndex a = 0; a < graph.atoms(); ++a)
    if (bending[r.skeleton.piece[a]] > 0.0) r.flipped[a] ^= 1;
}

}  // namespace

RotationSystem rotation_system(const EmbeddedGraph& graph) {
  RotationSystem r;
  r.skeleton = find_skeleton(graph);
  if (r.skeleton.problem) return r;
  order_and_normals(graph, r);
  carry_normals(graph, r);
  orient(graph, r);
  if (!r.skeleton.problem) point_outwards(graph, r);
  return r;
}

}  // namespace nanocarbon
