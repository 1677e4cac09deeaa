// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/steric_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "nanocarbon/core/neighbours_within.h"

namespace nanocarbon::annealing {

namespace {

constexpr double stiffness = 8;   // eV/Angstrom^2
constexpr double margin = 0.8;    // Angstrom
constexpr double block_side = 8;  // Angstrom

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

// Atoms at most `bonds` bonds away from the start, found breadth first; sorted.
void atoms_within_bonds(const StericContacts::Neighbours& neighbours, AtomIndex start, unsigned bonds,
                        std::vector<AtomIndex>& found) {
  found.assign(1, start);
  std::size_t shell = 0;
  for (unsigned distance = 0; distance < bonds; ++distance) {
    const std::size_t end = found.size();
    for (; shell < end; ++shell)
      for (const AtomIndex n : neighbours[found[shell]])
        if (n != no_atom && std::find(found.begin(), found.end(), n) == found.end()) found.push_back(n);
  }
  std::sort(found.begin(), found.end());
}

}  // namespace

double steric_pair(const Vec3& a, const Vec3& b, Vec3& gradient_at_a) {
  const Vec3 d = a - b;
  const double r2 = d.squaredNorm();
  if (r2 >= steric_reach * steric_reach) return 0;
  const double r = std::max(std::sqrt(r2), 1e-6), overlap = steric_reach - r;
  gradient_at_a -= stiffness * overlap / r * d;
  return 0.5 * stiffness * overlap * overlap;
}

void StericContacts::renew(std::span<const Vec3> positions, const FixedBondGraph& graph) {
  const Neighbours& neighbours = graph.neighbours;
  reference_.assign(positions.begin(), positions.end());
  const NeighbourList candidates = neighbours_within(positions, graph.space.cell(), steric_reach + margin);
  offsets_.assign(1, 0);
  near_.clear();
  const auto used = [&](AtomIndex a) {
    const auto& n = neighbours[a];
    return n[0] != no_atom || n[1] != no_atom || n[2] != no_atom;
  };
  Walks close;
  std::vector<AtomIndex> bonded;
  for (AtomIndex a = 0; a < positions.size(); ++a) {
    // In a flat sheet every candidate is within three bonds; only curved or folded places need the search.
    if (used(a)) {
      walk_three_bonds(neighbours, a, close);
      bonded.clear();
      for (const Neighbour& candidate : candidates.of(a)) {
        if (!used(candidate.atom) || std::find(close.begin(), close.end(), candidate.atom) != close.end())
          continue;
        if (bonded.empty()) atoms_within_bonds(neighbours, a, steric_excluded_bonds, bonded);
        if (!std::binary_search(bonded.begin(), bonded.end(), candidate.atom))
          near_.push_back(candidate.atom);
      }
    }
    offsets_.push_back(near_.size());
  }
  divide();
}

// Cubes of space that hold atoms of the reference, and which of them touch.
void StericContacts::divide() {
  using Cube = std::array<std::int64_t, 3>;
  std::vector<std::pair<Cube, AtomIndex>> atoms;
  atoms.reserve(reference_.size());
  for (AtomIndex a = 0; a < reference_.size(); ++a) {
    Cube cube;
    for (int d = 0; d < 3; ++d)
      cube[static_cast<std::size_t>(d)] =
          static_cast<std::int64_t>(std::floor(reference_[a][d] / block_side));
    atoms.emplace_back(cube, a);
  }
  std::sort(atoms.begin(), atoms.end());
  std::vector<Cube> cubes;
  block_of_.resize(reference_.size());
  for (const auto& [cube, a] : atoms) {
    if (cubes.empty() || cubes.back() != cube) cubes.push_back(cube);
    block_of_[a] = static_cast<std::uint32_t>(cubes.size() - 1);
  }
  blocks_.resize(cubes.size());
  adjacent_.clear();
  for (std::uint32_t c = 0; c < cubes.size(); ++c)
    for (std::int64_t k = 0; k < 27; ++k) {
      const Cube other = {cubes[c][0] + k / 9 - 1, cubes[c][1] + k / 3 % 3 - 1, cubes[c][2] + k % 3 - 1};
      if (!(cubes[c] < other)) continue;
      const auto found = std::lower_bound(cubes.begin(), cubes.end(), other);
      if (found != cubes.end() && *found == other)
        adjacent_.emplace_back(c, static_cast<std::uint32_t>(found - cubes.begin()));
    }
}

// Whether two atoms that are not listed may have come within the reach.
bool StericContacts::stale(std::span<const Vec3> positions, const Space& space) {
  if (reference_.size() != positions.size()) return true;
  double farthest = 0;
  for (std::size_t a = 0; a < positions.size(); ++a)
    farthest = std::max(farthest, (positions[a] - reference_[a]).squaredNorm());
  if (!(farthest > 0.25 * margin * margin)) return false;
  // Blocks at opposite faces of a cell are neighbours, but know nothing of each other.
  if (space.periodic()) return true;

  blocks_.assign(blocks_.size(), Block{});
  Vec3 mean = Vec3::Zero();
  for (std::size_t a = 0; a < positions.size(); ++a) {
    const Vec3 shift = positions[a] - reference_[a];
    blocks_[block_of_[a]].shift += shift;
    ++blocks_[block_of_[a]].atoms;
    mean += shift / static_cast<double>(positions.size());
  }
  for (Block& block : blocks_) block.shift /= block.atoms;
  double apart = 0;  // square of how far a shift is from the mean, at most
  for (std::size_t a = 0; a < positions.size(); ++a) {
    const Vec3 shift = positions[a] - reference_[a];
    Block& block = blocks_[block_of_[a]];
    block.spread = std::max(block.spread, (shift - block.shift).squaredNorm());
    apart = std::max(apart, (shift - mean).squaredNorm());
  }
  // Atoms of blocks that do not touch were at least a block's side apart.
  if (2 * std::sqrt(apart) > block_side - steric_reach) return true;
  for (const Block& block : blocks_)
    if (2 * std::sqrt(block.spread) > margin) return true;
  return std::any_of(adjacent_.begin(), adjacent_.end(), [&](const auto& pair) {
    const Block &one = blocks_[pair.first], &other = blocks_[pair.second];
    return (one.shift - other.shift).norm() + std::sqrt(one.spread) + std::sqrt(other.spread) > margin;
  });
}

double StericContacts::evaluate(std::span<const Vec3> positions, const FixedBondGraph& graph,
                                std::span<Vec3> gradient) {
  if (stale(positions, graph.space)) renew(positions, graph);
  double energy = 0;
  for (AtomIndex a = 0; a < positions.size(); ++a)
    for (const AtomIndex b : near(a)) {
      if (b < a) continue;
      Vec3 at_a = Vec3::Zero();
      energy += steric_pair(positions[a], graph.space.beside(positions[b], positions[a]), at_a);
      gradient[a] += at_a;
      gradient[b] -= at_a;
    }
  return energy;
}

}  // namespace nanocarbon::annealing
