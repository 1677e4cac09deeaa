// SPDX-License-Identifier: GPL-2.0-or-later
#include "bond_topology/surface_watch.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace nanocarbon {
namespace {

// Both ends of each bond.
topology::EmbeddedGraph graph_of(const WatchedAtoms& atoms) {
  std::vector<topology::BondEnd> ends;
  ends.reserve(2 * atoms.bonds.size());
  for (const topology::BondEnd& bond : atoms.bonds) {
    ends.push_back(bond);
    ends.push_back({bond.neighbour, bond.atom, -bond.vector});
  }
  return topology::embedded_graph(atoms.ids, atoms.elements, ends);
}

std::vector<topology::BondedIds> bonded_pairs(const WatchedAtoms& atoms) {
  std::vector<topology::BondedIds> pairs;
  pairs.reserve(atoms.bonds.size());
  for (const topology::BondEnd& bond : atoms.bonds) pairs.push_back({bond.atom, bond.neighbour});
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// Of each atom of the start: its place among the atoms now, or none.
constexpr std::size_t none = static_cast<std::size_t>(-1);
std::vector<std::size_t> places_now(const std::vector<std::int64_t>& start,
                                    const std::vector<std::int64_t>& now) {
  std::vector<std::size_t> places(start.size(), none);
  for (std::size_t s = 0, n = 0; s < start.size() && n < now.size();) {
    if (start[s] == now[n])
      places[s++] = n++;
    else
      ++(start[s] < now[n] ? s : n);
  }
  return places;
}

void mark(std::vector<AtomState>& atoms, const std::vector<std::int64_t>& ids, std::int64_t id,
          std::uint8_t state) {
  const auto found = std::lower_bound(ids.begin(), ids.end(), id);
  if (found != ids.end() && *found == id) atoms[found - ids.begin()].state = state;
}

}  // namespace

WatchStart start_watch(WatchedAtoms atoms, const topology::TopologyOptions& options) {
  WatchStart start;
  start.bonds = bonded_pairs(atoms);
  start.topology = topology::surface_topology(graph_of(atoms), options);
  start.atoms = std::move(atoms);
  return start;
}

WatchReport report(const WatchStart& start, const WatchedAtoms& now,
                   const topology::TopologyOptions& options) {
  WatchReport result;
  result.bonds = bonded_pairs(now);
  result.changes = topology::compare_bonds(start.bonds, result.bonds);
  result.topology = topology::surface_topology(graph_of(now), options);

  const std::vector<std::size_t> places = places_now(start.atoms.ids, now.ids);
  std::vector<std::uint32_t> components(places.size(), topology::no_component);
  for (std::size_t a = 0; a < places.size(); ++a)
    if (places[a] != none)
      components[a] = result.topology.component_of_atom[places[a]];
    else
      result.lost.push_back(start.atoms.ids[a]);
  const std::vector<bool> repelled = topology::repelled_atoms(start.topology.component_of_atom, components);
  for (std::size_t a = 0; a < places.size(); ++a)
    if (repelled[a]) result.repelled.push_back(start.atoms.ids[a]);

  topology::Judgement judgement =
      topology::judge(start.topology, result.topology, result.changes.none(), result.lost.size());
  result.verdict = judgement.verdict;
  result.reason = std::move(judgement.reason);

  for (std::size_t a = 0; a < now.ids.size(); ++a)
    result.atoms.push_back(
        {AtomState::unchanged, result.topology.coordination[a], result.topology.smallest_ring[a]});
  for (const auto* bonds : {&result.changes.broken, &result.changes.formed})
    for (const topology::BondedIds& bond : *bonds) {
      mark(result.atoms, now.ids, bond.first, AtomState::rebonded);
      mark(result.atoms, now.ids, bond.second, AtomState::rebonded);
    }
  for (const std::int64_t id : result.repelled) mark(result.atoms, now.ids, id, AtomState::repelled);
  return result;
}

}  // namespace nanocarbon
