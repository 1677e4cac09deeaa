// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/topology/face_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nanocarbon/topology/bridges.h"

namespace nanocarbon::topology {
namespace {

constexpr std::uint32_t none = Skeleton::none;

// A half-edge that a face goes back along, at the same place.
struct TwoSided {
  AtomIndex atom;
  std::uint32_t half_edge;
};

class DoubleSides {
 public:
  DoubleSides(const EmbeddedGraph& graph, const Skeleton& skeleton)
      : graph_(graph), skeleton_(skeleton), face_(graph.ends.size(), none), place_(graph.ends.size()) {}

  void walk(const Faces& faces, std::uint32_t f) {
    pairs_.clear();
    Vec3 at = Vec3::Zero();
    for (std::uint32_t k = faces.offsets[f]; k < faces.offsets[f + 1]; ++k) {
      const std::uint32_t h = faces.half_edges[k];
      const std::uint32_t back = skeleton_.twin[h];
      const Vec3 middle = at + 0.5 * graph_.vectors[h];
      if (face_[back] == f) pairs_.push_back({{faces.atoms[k], h}, middle - place_[back]});
      face_[h] = f;
      place_[h] = middle;
      at += graph_.vectors[h];
    }
    // A face that goes on through a periodic boundary comes by again one period, `at`, further on.
    for (const Pair& pair : pairs_)
      for (const Vec3& period : {Vec3(Vec3::Zero()), at, Vec3(-at)})
        if ((pair.apart - period).squaredNorm() < same * same) {
          found.push_back(pair.bond);
          break;
        }
  }

  std::vector<TwoSided> found;

 private:
  static constexpr double same = 0.1;  // Angstrom

  struct Pair {
    TwoSided bond;
    Vec3 apart;
  };

  const EmbeddedGraph& graph_;
  const Skeleton& skeleton_;
  std::vector<std::uint32_t> face_;  // of each half-edge: the face that went along it last
  std::vector<Vec3> place_;          // and where its middle was then
  std::vector<Pair> pairs_;
};

std::optional<NotASurface> find_double_side(const EmbeddedGraph& graph, const RotationSystem& rotation,
                                            const Faces& faces) {
  DoubleSides sides(graph, rotation.skeleton);
  for (std::uint32_t f = 0; f < faces.size(); ++f) sides.walk(faces, f);
  if (sides.found.empty()) return std::nullopt;
  const std::vector<std::uint8_t> is_bridge = find_bridges(graph, rotation.skeleton);
  for (const TwoSided& bond : sides.found)
    if (!is_bridge[bond.half_edge])
      return NotASurface{
          fmt::format("the face beside the bond of atom ID {} with atom ID {} comes back on its other side",
                      graph.id(bond.atom), graph.id(graph.ends[bond.half_edge])),
          bond.atom};
  return std::nullopt;
}

std::optional<NotASurface> find_doubtful_turning(const EmbeddedGraph& graph, const Faces& faces,
                                                 int max_ring) {
  constexpr double half_turn = std::numbers::pi;
  constexpr double doubt = 0.25 * half_turn;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::uint32_t size = faces.offsets[f + 1] - faces.offsets[f];
    if (size > static_cast<std::uint32_t>(max_ring) || std::abs(faces.turning[f] - half_turn) >= doubt)
      continue;
    const AtomIndex atom = faces.atoms[faces.offsets[f]];
    return NotASurface{
        fmt::format("a face of {} atoms at atom ID {} is too crumpled to tell a ring from a boundary", size,
                    graph.id(atom)),
        atom};
  }
  return std::nullopt;
}

}  // namespace

std::optional<NotASurface> find_doubtful_face(const EmbeddedGraph& graph, const RotationSystem& rotation,
                                              const Faces& faces, int max_ring) {
  if (auto problem = find_double_side(graph, rotation, faces)) return problem;
  return find_doubtful_turning(graph, faces, max_ring);
}

}  // namespace nanocarbon::topology
