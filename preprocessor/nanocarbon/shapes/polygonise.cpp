// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/shapes/polygonise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <unordered_map>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/join_points.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/shapes/even_out.h"

namespace nanocarbon::shapes {
namespace {

using Place = std::array<std::int64_t, 3>;
using Node = std::int64_t;

//! The body-centred cubic lattice in a box: corners of cubes and their centres, as nodes with numbers.
class Lattice {
 public:
  Lattice(const Vec3& low, const Vec3& high, double spacing) : spacing_(spacing) {
    for (int d = 0; d < 3; ++d)
      cubes_[d] = std::max<std::int64_t>(3, std::llround(std::ceil((high[d] - low[d]) / spacing)) + 2);
    const Vec3 size(spacing * static_cast<double>(cubes_[0]), spacing * static_cast<double>(cubes_[1]),
                    spacing * static_cast<double>(cubes_[2]));
    origin_ = 0.5 * (low + high - size);
    corners_ = (cubes_[0] + 1) * (cubes_[1] + 1) * (cubes_[2] + 1);
  }

  const Place& cubes() const { return cubes_; }
  std::int64_t size() const { return corners_ + cubes_[0] * cubes_[1] * cubes_[2]; }
  Node corner(const Place& p) const { return p[0] + (cubes_[0] + 1) * (p[1] + (cubes_[1] + 1) * p[2]); }
  Node centre(const Place& p) const { return corners_ + p[0] + cubes_[0] * (p[1] + cubes_[1] * p[2]); }

  template <typename Visit>  // visit(node, place, is_centre)
  void for_each_node(const Visit& visit) const {
    for (const int is_centre : {0, 1})
      for (std::int64_t k = 0; k <= cubes_[2] - is_centre; ++k)
        for (std::int64_t j = 0; j <= cubes_[1] - is_centre; ++j)
          for (std::int64_t i = 0; i <= cubes_[0] - is_centre; ++i) {
            const Place p = {i, j, k};
            visit(is_centre ? centre(p) : corner(p), p, is_centre == 1);
          }
  }

  Vec3 point(const Place& p, bool is_centre) const {
    const double shift = is_centre ? 0.5 : 0.0;
    return origin_ +
           spacing_ * (Vec3(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])) +
                       Vec3::Constant(shift));
  }

  bool at_wall(const Place& p, bool is_centre, int layers = 1) const {
    for (int d = 0; d < 3; ++d)
      if (p[d] < layers || p[d] > cubes_[d] - (is_centre ? 1 : 0) - layers) return true;
    return false;
  }

  //! The 14 nodes joined to a node that is not at the wall: 6 of its own kind, 8 of the other.
  std::array<Node, 14> joined_to(const Place& p, bool is_centre) const {
    std::array<Node, 14> nodes;
    std::size_t n = 0;
    for (int d = 0; d < 3; ++d)
      for (const int step : {-1, 1}) {
        Place q = p;
        q[d] += step;
        nodes[n++] = is_centre ? centre(q) : corner(q);
      }
    const int back = is_centre ? 0 : -1;
    for (int corner_bits = 0; corner_bits < 8; ++corner_bits) {
      const Place q = {p[0] + back + (corner_bits & 1), p[1] + back + (corner_bits >> 1 & 1),
                       p[2] + back + (corner_bits >> 2 & 1)};
      nodes[n++] = is_centre ? corner(q) : centre(q);
    }
    return nodes;
  }

  //! Each tetrahedron: two centres joined through a face, and two neighbouring corners of that face. Positive
  //! volume.
  template <typename Visit>
  void for_each_tetrahedron(const Visit& visit) const {
    for (std::int64_t k = 0; k < cubes_[2]; ++k)
      for (std::int64_t j = 0; j < cubes_[1]; ++j)
        for (std::int64_t i = 0; i < cubes_[0]; ++i)
          for (int d = 0; d < 3; ++d) {
            const Place here = {i, j, k};
            if (here[d] + 1 == cubes_[d]) continue;
            Place there = here;
            ++there[d];
            std::array<Node, 4> face;
            for (int c = 0; c < 4; ++c) {
              Place q = there;
              q[(d + 1) % 3] += c == 1 || c == 2;
              q[(d + 2) % 3] += c == 2 || c == 3;
              face[c] = corner(q);
            }
            for (int c = 0; c < 4; ++c)
              visit(std::array<Node, 4>{centre(here), centre(there), face[c], face[(c + 1) % 4]});
          }
  }

 private:
  double spacing_;
  Vec3 origin_;
  Place cubes_;
  std::int64_t corners_;
};

struct Samples {
  std::vector<Vec3> points;
  std::vector<double> values;
};

Samples sample(const Lattice& lattice, const ImplicitShape& shape, double spacing) {
  Samples s{std::vector<Vec3>(static_cast<std::size_t>(lattice.size())),
            std::vector<double>(static_cast<std::size_t>(lattice.size()))};
  lattice.for_each_node([&](Node node, const Place& p, bool is_centre) {
    s.points[node] = lattice.point(p, is_centre);
    const double value = shape(s.points[node]);
    // Walls are outside; zeros are made by snap() alone.
    s.values[node] = lattice.at_wall(p, is_centre) ? std::max(value, 0.5 * spacing)
                     : value == 0.0                ? 1e-12 * spacing
                                                   : value;
  });
  return s;
}

//! Moves nodes that have a crossing within a quarter of one of their edges onto it.
void snap(const Lattice& lattice, Samples& s) {
  const double closest = 0.25;
  const Samples before = s;
  lattice.for_each_node([&](Node node, const Place& p, bool is_centre) {
    // Against a wall the shape is cut off sharply, and snapping would pinch it.
    if (lattice.at_wall(p, is_centre, 2)) return;
    double nearest = 1e300;
    for (const Node other : lattice.joined_to(p, is_centre)) {
      const double here = before.values[node], there = before.values[other];
      if ((here < 0.0) == (there < 0.0)) continue;
      const double fraction = here / (here - there);
      const Vec3 move = fraction * (before.points[other] - before.points[node]);
      if (fraction > closest || move.norm() >= nearest) continue;
      nearest = move.norm();
      s.points[node] = before.points[node] + move;
      s.values[node] = 0.0;
    }
  });
}

//! Collects the surface tetrahedron by tetrahedron.
class Marcher {
 public:
  explicit Marcher(const Samples& samples) : s_(samples) {}

  void add(std::array<Node, 4> v) {
    flipped_ = !sort_by_sign(v);
    const auto sign = [&](int i) { return sign_of(v[i]); };
    const int inside =
        static_cast<int>(std::count_if(v.begin(), v.end(), [&](Node n) { return sign_of(n) < 0; }));
    if (inside == 1 && sign(3) == 0) {
      // A face wholly on the surface: there may be another inside tetrahedron on its other side.
      emit_face({vertex(v[1], v[1]), vertex(v[2], v[2]), vertex(v[3], v[3])});
    } else if (inside == 1) {
      emit({vertex(v[0], v[1]), vertex(v[0], v[2]), vertex(v[0], v[3])});
    } else if (inside == 2 && sign(3) > 0 && sign(2) == 0) {
      emit({vertex(v[2], v[2]), vertex(v[0], v[3]), vertex(v[1], v[3])});
    } else if (inside == 2 && sign(3) > 0) {
      emit_quad(vertex(v[1], v[2]), vertex(v[0], v[2]), vertex(v[0], v[3]), vertex(v[1], v[3]));
    } else if (inside == 3 && sign(3) > 0) {
      emit({vertex(v[0], v[3]), vertex(v[1], v[3]), vertex(v[2], v[3])});
    }
  }

  TriangleMesh finish() {
    for (const Triangle& face : faces_)
      if (!faces_.contains(rotated({face[0], face[2], face[1]}))) mesh_.triangles.push_back(face);
    mesh::drop_unused_points(mesh_);
    return std::move(mesh_);
  }

 private:
  int sign_of(Node n) const { return (s_.values[n] > 0.0) - (s_.values[n] < 0.0); }

  //! Inside nodes first, those on the surface next. \return whether that was an even permutation
  bool sort_by_sign(std::array<Node, 4>& v) const {
    bool even = true;
    for (int end = 3; end > 0; --end)
      for (int i = 0; i < end; ++i)
        if (sign_of(v[i]) > sign_of(v[i + 1])) std::swap(v[i], v[i + 1]), even = !even;
    return even;
  }

  static Triangle rotated(Triangle t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
  }

  VertexIndex vertex(Node inside, Node other) {
    if (sign_of(other) == 0) inside = other;
    const auto key = std::pair(std::min(inside, other), std::max(inside, other));
    const auto [entry, added] = index_.try_emplace(key, static_cast<VertexIndex>(mesh_.points.size()));
    if (added) {
      const double a = s_.values[inside], b = s_.values[other];
      const double fraction = inside == other ? 0.0 : a / (a - b);
      mesh_.points.push_back(s_.points[inside] + fraction * (s_.points[other] - s_.points[inside]));
    }
    return entry->second;
  }

  void emit(Triangle t) { mesh_.triangles.push_back(flipped_ ? Triangle{t[0], t[2], t[1]} : t); }
  void emit_face(Triangle t) { faces_.insert(rotated(flipped_ ? Triangle{t[0], t[2], t[1]} : t)); }
  void emit_quad(VertexIndex a, VertexIndex b, VertexIndex c, VertexIndex d) {
    const auto length = [&](VertexIndex i, VertexIndex j) {
      return (mesh_.points[i] - mesh_.points[j]).squaredNorm();
    };
    if (length(a, c) <= length(b, d)) {
      emit({a, b, c});
      emit({a, c, d});
    } else {
      emit({a, b, d});
      emit({b, c, d});
    }
  }

  struct PairHash {
    std::size_t operator()(const std::pair<Node, Node>& p) const {
      return static_cast<std::size_t>(p.first) * 0x9e3779b97f4a7c15ull ^
             static_cast<std::size_t>(p.second) * 0xff51afd7ed558ccdull;
    }
  };

  const Samples& s_;
  bool flipped_ = false;
  TriangleMesh mesh_;
  std::unordered_map<std::pair<Node, Node>, VertexIndex, PairHash> index_;  // looked up only, never walked
  std::set<Triangle> faces_;
};

TriangleMesh march(const Lattice& lattice, const Samples& samples) {
  Marcher marcher(samples);
  lattice.for_each_tetrahedron([&](const std::array<Node, 4>& tetrahedron) { marcher.add(tetrahedron); });
  return marcher.finish();
}

bool is_oriented_manifold(const TriangleMesh& mesh) {
  const mesh::MeshTopology topology = mesh::mesh_topology(mesh);
  return topology.manifold() && topology.consistently_wound();
}

}  // namespace

TriangleMesh polygonise(const ImplicitShape& shape, const Vec3& low, const Vec3& high, double edge) {
  // Edges of the lattice are 0.87 and 1 spacing long; those of the surface turn out shorter.
  const double spacing = 1.5 * edge;
  if (!(edge > 0.0) || ((high - low).array() / spacing + 3.0).prod() > 5e7)
    throw UserError(Failure::usage, "the edge is too short for a shape of this size; use a longer one");
  const Lattice lattice(low, high, spacing);
  Samples samples = sample(lattice, shape, spacing);
  const Samples as_sampled = samples;
  snap(lattice, samples);
  TriangleMesh mesh = march(lattice, samples);
  if (!is_oriented_manifold(mesh)) mesh = march(lattice, as_sampled);
  if (mesh.triangles.empty())
    throw UserError(Failure::usage, "the edge is too long to show the shape; use a shorter one");
  even_out(mesh, shape, edge, 8);
  return mesh;
}

}  // namespace nanocarbon::shapes
