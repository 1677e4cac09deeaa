// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/topology/orientation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "nanocarbon/core/disjoint_sets.h"
#include "nanocarbon/topology/short_cycles.h"

namespace nanocarbon::topology {
namespace {

constexpr std::uint32_t none = Skeleton::none;
constexpr double undecided = 0.1;  // cosine; within six degrees of a right angle
constexpr int short_cycle = 12;    // bonds

struct TwistedBond {
  AtomIndex atom;
  std::uint32_t half_edge;
  double cosine;  // of the angle by which it is twisted
};

double cosine_of_twist(const Vec3& normal, const Vec3& other, const Vec3& along) {
  const Vec3 unit = along.normalized();
  const Vec3 a = normal - normal.dot(unit) * unit, b = other - other.dot(unit) * unit;
  const double product = a.norm() * b.norm();
  return product > 1e-6 ? a.dot(b) / product : 0.0;
}

// All bonds of the skeleton, roughly the least twisted (or most: what counts is that it is not a right angle)
// first.
std::vector<TwistedBond> bonds_by_confidence(const EmbeddedGraph& graph, const RotationSystem& r) {
  std::array<std::vector<TwistedBond>, 20> bins;
  for (AtomIndex a = 0; a < graph.atoms(); ++a)
    for (std::uint32_t h = graph.offsets[a]; h < graph.offsets[a + 1]; ++h) {
      const std::uint32_t back = r.skeleton.twin[h];
      if (back == none || back < h || r.bare_cycle[r.skeleton.component[a]]) continue;
      const double cosine = cosine_of_twist(r.normals[a], r.normals[graph.ends[h]], graph.vectors[h]);
      const auto bin = static_cast<std::size_t>((1.0 - std::abs(cosine)) * bins.size());
      bins[std::min(bin, bins.size() - 1)].push_back({a, h, cosine});
    }
  std::vector<TwistedBond> bonds;
  for (const std::vector<TwistedBond>& bin : bins) bonds.insert(bonds.end(), bin.begin(), bin.end());
  return bonds;
}

class Orientation {
 public:
  Orientation(const EmbeddedGraph& graph, RotationSystem& rotation)
      : graph_(graph), r_(rotation), sides_(graph.atoms()), open_(graph.ends.size(), 0) {
    r_.twisted.assign(graph.ends.size(), 0);
  }

  // Joins what a bond joins; sets it aside where it contradicts or says nothing.
  void take(const TwistedBond& bond) {
    const AtomIndex end = graph_.ends[bond.half_edge];
    const bool twisted = bond.cosine < 0.0;
    const bool joins = sides_.place(bond.atom).root != sides_.place(end).root;
    const bool says = std::abs(bond.cosine) >= undecided;
    if (joins || (says && implied(bond) == twisted)) {
      // Where it says nothing but joins two parts any twist will do: either part may be turned over as a
      // whole.
      sides_.join(bond.atom, end, twisted);
      set(bond, twisted);
    } else {
      left_.push_back(bond);
      mark_open(bond, 1);
    }
  }

  void settle_on_short_cycles() {
    for (int pass = 0; pass < 2; ++pass)  // a bond settled may close the short cycle of another
      std::erase_if(left_, [&](const TwistedBond& bond) {
        if (!is_on_short_cycle(graph_, r_.skeleton, bond.atom, bond.half_edge, short_cycle, open_))
          return false;
        set(bond, implied(bond));
        mark_open(bond, 0);
        return true;
      });
  }

  void finish() {
    r_.one_sided.assign(r_.skeleton.components, 0);
    for (const TwistedBond& bond : left_) {
      if (std::abs(bond.cosine) < undecided) {
        r_.skeleton.problem =
            NotASurface{fmt::format("the bond of atom ID {} with atom ID {} is twisted by a right angle, so "
                                    "that its sides cannot be told",
                                    graph_.id(bond.atom), graph_.id(graph_.ends[bond.half_edge])),
                        bond.atom};
        return;
      }
      set(bond, bond.cosine < 0.0);
      r_.one_sided[r_.skeleton.component[bond.atom]] = 1;
    }
    r_.flipped.resize(graph_.atoms());
    for (AtomIndex a = 0; a < graph_.atoms(); ++a) r_.flipped[a] = sides_.place(a).opposite;
  }

 private:
  bool implied(const TwistedBond& bond) {
    return sides_.place(bond.atom).opposite != sides_.place(graph_.ends[bond.half_edge]).opposite;
  }
  void set(const TwistedBond& bond, bool twisted) {
    r_.twisted[bond.half_edge] = r_.twisted[r_.skeleton.twin[bond.half_edge]] = twisted;
  }
  void mark_open(const TwistedBond& bond, std::uint8_t open) {
    open_[bond.half_edge] = open_[r_.skeleton.twin[bond.half_edge]] = open;
  }

  const EmbeddedGraph& graph_;
  RotationSystem& r_;
  DisjointSets sides_;
  std::vector<TwistedBond> left_;
  std::vector<std::uint8_t> open_;  // half-edges of the bonds left
};

// Turns over components whose normals point inwards: on the whole, a surface bends away from its outer
// normal.
void point_outwards(const EmbeddedGraph& graph, RotationSystem& r) {
  std::vector<double> bending(r.skeleton.components, 0.0);
  for (AtomIndex a = 0; a < graph.atoms(); ++a) {
    const Vec3 normal = r.flipped[a] ? Vec3(-r.normals[a]) : r.normals[a];
    for (std::uint32_t h = graph.offsets[a]; h < graph.offsets[a + 1]; ++h)
      if (r.skeleton.twin[h] != Skeleton::none)
        bending[r.skeleton.component[a]] += normal.dot(graph.vectors[h]);
  }
  for (AtomIndex a = 0; a < graph.atoms(); ++a)
    if (bending[r.skeleton.component[a]] > 0.0) r.flipped[a] ^= 1;
}

}  // namespace

void orient(const EmbeddedGraph& graph, RotationSystem& rotation) {
  Orientation orientation(graph, rotation);
  for (const TwistedBond& bond : bonds_by_confidence(graph, rotation)) orientation.take(bond);
  orientation.settle_on_short_cycles();
  orientation.finish();
  if (!rotation.skeleton.problem) point_outwards(graph, rotation);
}

}  // namespace nanocarbon::topology
