// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/boundary_units.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <unordered_set>

#include "nanocarbon/core/space.h"

namespace nanocarbon::molecule {
namespace {

// A bond as it is passed from one atom to another.
std::uint64_t side(AtomIndex from, AtomIndex to) { return (std::uint64_t{from} << 32) | to; }
AtomIndex end_of(std::uint64_t side) { return static_cast<AtomIndex>(side); }

// The sides of bonds that no ring passes, and which of them follows each.
class Boundary {
 public:
  explicit Boundary(const Molecule& molecule) : neighbours_(molecule.size()) {
    for (const Bond& bond : molecule.bonds) {
      if (molecule.elements[bond.first] != Element::carbon ||
          molecule.elements[bond.second] != Element::carbon)
        continue;
      neighbours_[bond.first].push_back(bond.second);
      neighbours_[bond.second].push_back(bond.first);
    }
    for (std::size_t r = 0; r < molecule.rings.size(); ++r) {
      const auto ring = molecule.rings[r];
      for (std::size_t k = 0; k < ring.size(); ++k)
        next_in_ring_[side(ring[k], ring[(k + 1) % ring.size()])] = ring[(k + 2) % ring.size()];
    }
    for (AtomIndex a = 0; a < molecule.size(); ++a)
      for (const AtomIndex n : neighbours_[a])
        if (!next_in_ring_.contains(side(a, n))) sides_.push_back(side(a, n));
  }

  std::span<const std::uint64_t> sides() const { return sides_; }
  std::size_t degree(AtomIndex atom) const { return neighbours_[atom].size(); }

  // Turning at an atom, the boundary goes where no ring does; at the end of a chain, back.
  std::uint64_t after(std::uint64_t passed) const {
    const AtomIndex from = static_cast<AtomIndex>(passed >> 32), at = end_of(passed);
    std::uint64_t next = side(at, from);
    for (const AtomIndex to : neighbours_[at]) {
      if (to == from || next_in_ring_.contains(side(at, to))) continue;
      const auto ring = next_in_ring_.find(side(to, at));
      const bool inside = ring != next_in_ring_.end() && ring->second == from;
      if (!inside || degree(at) == 2) next = side(at, to);
    }
    return next;
  }

 private:
  std::vector<std::vector<AtomIndex>> neighbours_;
  std::unordered_map<std::uint64_t, AtomIndex> next_in_ring_;  // looked up only, never walked through
  std::vector<std::uint64_t> sides_;
};

void count_chains(std::span<const std::size_t> chains, BoundaryUnits& units) {
  const std::size_t count = chains.size();
  std::vector<bool> paired(count, false);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t next = (k + 1) % count;
    if (next == k || paired[k] || paired[next]) continue;
    if (std::min(chains[k], chains[next]) == 2 && std::max(chains[k], chains[next]) == 4)
      paired[k] = paired[next] = true;
  }
  for (std::size_t k = 0; k < count; ++k) {
    units.zigzag += chains[k] == 3;
    units.armchair += paired[k];
    if (units.chains.size() <= chains[k]) units.chains.resize(chains[k] + 1, 0);
    ++units.chains[chains[k]];
  }
}

}  // namespace

BoundaryUnits boundary_units(const Molecule& molecule) {
  const Boundary boundary(molecule);
  const Space space(molecule.cell);
  BoundaryUnits units;
  for (AtomIndex a = 0; a < molecule.size(); ++a)
    units.dead_ends += molecule.elements[a] == Element::carbon && boundary.degree(a) < 2;
  std::unordered_set<std::uint64_t> seen;  // looked up only
  for (const std::uint64_t first : boundary.sides()) {
    if (seen.contains(first)) continue;
    ++units.loops;
    std::vector<AtomIndex> passed;
    for (std::uint64_t at = first; seen.insert(at).second; at = boundary.after(at))
      passed.push_back(end_of(at));
    std::vector<std::size_t> open;  // places of the open atoms
    for (std::size_t k = 0; k < passed.size(); ++k)
      if (boundary.degree(passed[k]) == 2) open.push_back(k);
    std::vector<std::size_t> chains;
    for (std::size_t k = 0; k < open.size(); ++k) {
      const std::size_t next = open[(k + 1) % open.size()];
      chains.push_back((next + passed.size() - open[k] - 1) % passed.size() + 2);
      units.length +=
          space.displacement(molecule.positions[passed[open[k]]], molecule.positions[passed[next]]).norm();
    }
    units.open_atoms += chains.size();
    count_chains(chains, units);
  }
  return units;
}

}  // namespace nanocarbon::molecule
