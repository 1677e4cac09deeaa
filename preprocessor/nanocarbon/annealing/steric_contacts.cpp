// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/steric_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "nanocarbon/core/chunks.h"
#include "nanocarbon/core/neighbours_within.h"
#include "nanocarbon/topology/bond_shells.h"

namespace nanocarbon::annealing {

namespace {

constexpr double stiffness = 8;  // eV/Angstrom^2

// With fewer atoms all pairs are renewed at once.
constexpr std::size_t least_large = 2000;

// Atoms that walks of two and of three bonds lead to: all within three bonds, since walks may turn back. Some
// stand there twice; no_atom fills up at boundaries.
using Walks = std::array<AtomIndex, 9 + 27>;

void walk_three_bonds(const StericContacts::Neighbours& neighbours, AtomIndex start, Walks& found) {
  found.fill(no_atom);
  std::size_t second = 0, third = 9;
  for (const AtomIndex n : neighbours[start]) {
    if (n == no_atom) continue;
    for (const AtomIndex m : neighbours[n]) {
      if (m == no_atom) continue;
      found[second++] = m;
      for (const AtomIndex l : neighbours[m]) found[third++] = l;
    }
  }
}

// Whether a walk of three bonds leads from one atom to the other, or a shorter one.
bool within_three_bonds(const StericContacts::Neighbours& neighbours, AtomIndex one, AtomIndex other) {
  const auto& ends = neighbours[other];
  for (const AtomIndex n : neighbours[one]) {
    if (n == no_atom) continue;
    if (n == other) return true;
    for (const AtomIndex m : neighbours[n]) {
      if (m == no_atom) continue;
      if (m == other || std::find(ends.begin(), ends.end(), m) != ends.end()) return true;
    }
  }
  return false;
}

// Atoms at most `bonds` bonds away from the start, found breadth first; sorted.
void atoms_within_bonds(const StericContacts::Neighbours& neighbours, AtomIndex start, unsigned bonds,
                        std::vector<AtomIndex>& found) {
  found.assign(1, start);
  std::size_t shell = 0;
  for (unsigned k = 0; k < bonds; ++k)
    topology::add_bond_shell(
        [&](AtomIndex a) { return neighbours[a]; }, found, shell,
        [&](AtomIndex n) { return n != no_atom && std::find(found.begin(), found.end(), n) == found.end(); });
  std::sort(found.begin(), found.end());
}

}  // namespace

double steric_pair(const Vec3& a, const Vec3& b, double reach, Vec3& gradient_at_a) {
  const Vec3 d = a - b;
  const double r2 = d.squaredNorm();
  if (r2 >= reach * reach) return 0;
  const double r = std::max(std::sqrt(r2), 1e-6), overlap = reach - r;
  gradient_at_a -= stiffness * overlap / r * d;
  return 0.5 * stiffness * overlap * overlap;
}

namespace {

bool used(const StericContacts::Neighbours& neighbours, AtomIndex a) {
  const auto& n = neighbours[a];
  return n[0] != no_atom || n[1] != no_atom || n[2] != no_atom;
}

}  // namespace

void StericContacts::start(double reach) {
  reach_ = reach;
  watch_ = ApproachWatch(reach, steric_margin);
  pairs_ = KeptPairs(reach, steric_margin);
}

void StericContacts::renew(std::span<const Vec3> positions, const FixedBondGraph& graph, ThreadTeam* team) {
  const Neighbours& neighbours = graph.neighbours;
  start(graph.steric_reach);
  watch_.set(positions);
  const NeighbourList candidates =
      neighbours_within(positions, graph.space.cell(), reach_ + steric_margin, team);
  offsets_.assign(1, 0);
  near_.clear();
  Walks close;
  std::vector<AtomIndex> bonded;
  for (AtomIndex a = 0; a < positions.size(); ++a) {
    // In a flat sheet every candidate is within three bonds; only curved or folded places need the search.
    if (used(neighbours, a)) {
      walk_three_bonds(neighbours, a, close);
      bonded.clear();
      for (const Neighbour& candidate : candidates.of(a)) {
        if (!used(neighbours, candidate.atom) ||
            std::find(close.begin(), close.end(), candidate.atom) != close.end())
          continue;
        if (bonded.empty()) atoms_within_bonds(neighbours, a, steric_excluded_bonds, bonded);
        if (!std::binary_search(bonded.begin(), bonded.end(), candidate.atom))
          near_.push_back(candidate.atom);
      }
    }
    offsets_.push_back(near_.size());
  }
}

void StericContacts::renew_where_nearer(std::span<const Vec3> positions, const FixedBondGraph& graph,
                                        ThreadTeam* team) {
  const Neighbours& neighbours = graph.neighbours;
  const auto apart = [&](AtomIndex a, AtomIndex b) {
    return used(neighbours, a) && used(neighbours, b) && !within_three_bonds(neighbours, a, b);
  };
  if (pairs_.update(positions, apart, team)) pairs_.rows(offsets_, near_);
}

double StericContacts::evaluate(std::span<const Vec3> positions, const FixedBondGraph& graph,
                                std::span<Vec3> gradient, ThreadTeam* team) {
  if (reach_ != graph.steric_reach) start(graph.steric_reach);
  if (!graph.space.periodic() && positions.size() >= least_large)
    renew_where_nearer(positions, graph, team);
  else if (watch_.may_be_closer(positions, !graph.space.periodic(), team))
    renew(positions, graph, team);
  if (near_.empty()) return 0;
  // Each pair from both of its atoms: no two threads add to one gradient.
  return sum_chunks(team, positions.size(), [&](std::size_t begin, std::size_t end) {
    double energy = 0;
    for (std::size_t a = begin; a < end; ++a)
      for (const AtomIndex b : near(static_cast<AtomIndex>(a))) {
        const double pair =
            steric_pair(positions[a], graph.space.beside(positions[b], positions[a]), reach_, gradient[a]);
        if (b > a) energy += pair;
      }
    return energy;
  });
}

}  // namespace nanocarbon::annealing
