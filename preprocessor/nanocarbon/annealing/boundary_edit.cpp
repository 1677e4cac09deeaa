// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/boundary_edit.h"

#include <algorithm>

namespace nanocarbon::annealing {

namespace {

constexpr std::uint32_t most_added = added_atoms.size();

bool has(const std::vector<RingIndex>& link, RingIndex ring) {
  return std::find(link.begin(), link.end(), ring) != link.end();
}

// The only side of an atom on the boundary; 3 if there is none or more than one.
unsigned open_slot(const TrivalentAtom& atom) {
  unsigned found = 3, count = 0;
  for (unsigned s = 0; s < 3; ++s)
    if (atom.neighbour[s] == no_atom) {
      found = s;
      ++count;
    }
  return count == 1 ? found : 3;
}

}  // namespace

std::optional<NetworkEdit> insert_open_atom(const TrivalentNetwork& network, AtomIndex atom, unsigned slot) {
  AtomIndex before = atom, after = network.atoms[atom].neighbour[slot];
  if (after == no_atom) return {};
  RingIndex chain = network.atoms[atom].ring[(slot + 2) % 3], ring = network.atoms[atom].ring[(slot + 1) % 3];
  if (network.rings[chain].boundary == network.rings[ring].boundary) return {};
  if (network.rings[ring].boundary) {  // seen from the other end, it is the atom that comes first
    std::swap(chain, ring);
    std::swap(before, after);
  }
  std::vector<AtomIndex> atoms;
  atoms_of_ring(network, chain, atoms);
  const auto place = std::find(atoms.begin(), atoms.end(), before) - atoms.begin();
  const int size = static_cast<int>(atoms.size()), kept = static_cast<int>(place) + 1;
  const RingIndex rest = added_rings[0];
  const AtomIndex x = added_atoms[0];
  NetworkEdit edit{
      NetworkEdit::Kind::insert, {}, {{chain, kept + 1 - size}, {rest, size - kept + 1}, {ring, 1}}};
  edit.added = 1;
  edit.rings_added = 1;
  edit.new_rings_open = true;
  edit.centre = {x};
  edit.polygon = 3;
  EditBuilder builder(network, edit);
  builder.rebond(before, after, x);
  builder.rebond(after, before, x);
  for (std::size_t k = static_cast<std::size_t>(kept); k < atoms.size(); ++k)
    builder.relabel(atoms[k], chain, rest);
  builder.add(x, {{after, no_atom, before}, {chain, ring, rest}});
  return edit;
}

std::optional<NetworkEdit> remove_open_atom(const TrivalentNetwork& network, AtomIndex atom) {
  const TrivalentAtom& x = network.atoms[atom];
  const unsigned s = open_slot(x);
  if (s == 3) return {};
  const RingIndex ring = x.ring[s], second = x.ring[(s + 1) % 3], first = x.ring[(s + 2) % 3];
  const AtomIndex before = x.neighbour[(s + 1) % 3], after = x.neighbour[(s + 2) % 3];
  if (network.rings[ring].boundary || slot_of_neighbour(network.atoms[before], after) < 3) return {};
  std::vector<AtomIndex> atoms;
  std::vector<RingIndex> link_first, link_second;
  link_of(network, first, atoms, link_first);
  link_of(network, second, atoms, link_second);
  for (const RingIndex r : link_first)
    if (r != ring && has(link_second, r)) return {};
  const int size = static_cast<int>(network.rings[second].size);
  NetworkEdit edit{NetworkEdit::Kind::remove, {}, {{first, size - 2}, {second, -size}, {ring, -1}}};
  EditBuilder builder(network, edit);
  builder.rebond(before, atom, after);
  builder.rebond(after, atom, before);
  for (const AtomIndex member : atoms)  // of the second chain, listed last
    if (member != atom) builder.relabel(member, second, first);
  builder.remove(atom);
  return edit;
}

std::optional<NetworkEdit> close_chain(const TrivalentNetwork& network, RingIndex chain, std::uint32_t size) {
  const TrivalentRing& closing = network.rings[chain];
  if (!closing.boundary || closing.size < shortest_chain || size <= closing.size ||
      size - closing.size > most_added)
    return {};
  const std::uint32_t added = size - closing.size;
  std::vector<AtomIndex> atoms;
  std::vector<RingIndex> link;
  link_of(network, chain, atoms, link);
  const RingIndex from = link.back(), to = link.front();
  if (from == to) return {};
  NetworkEdit edit{NetworkEdit::Kind::close, {}, {{chain, static_cast<int>(added)}, {from, 1}, {to, 1}}};
  if (added == 1) {
    std::vector<AtomIndex> others;
    link_of(network, from, others, link);
    if (has(link, to)) return {};
  }
  edit.added = static_cast<int>(added);
  edit.rings_added = edit.added - 1;
  edit.new_rings_open = true;
  edit.closed = chain;
  edit.polygon = size;
  EditBuilder builder(network, edit);
  for (std::uint32_t k = 0; k + 1 < added; ++k) edit.rings.push_back({added_rings[k], 2});
  for (std::uint32_t k = 0; k < added; ++k) {
    const AtomIndex next = k + 1 < added ? added_atoms[k + 1] : atoms.front();
    const AtomIndex previous = k > 0 ? added_atoms[k - 1] : atoms.back();
    builder.add(added_atoms[k],
                {{no_atom, next, previous},
                 {chain, k > 0 ? added_rings[k - 1] : from, k + 1 < added ? added_rings[k] : to}});
    edit.centre.push_back(added_atoms[k]);
  }
  TrivalentAtom& last = builder.record(atoms.back());
  last.neighbour[(slot_of_ring(last, chain) + 1) % 3] = added_atoms[0];
  TrivalentAtom& first = builder.record(atoms.front());
  first.neighbour[(slot_of_ring(first, chain) + 2) % 3] = added_atoms[added - 1];
  return edit;
}

std::optional<NetworkEdit> open_ring(const TrivalentNetwork& network, RingIndex ring) {
  if (network.rings[ring].boundary) return {};
  std::vector<AtomIndex> atoms;
  std::vector<RingIndex> link;
  link_of(network, ring, atoms, link);
  const std::size_t size = atoms.size();
  const auto is_open = [&](std::size_t k) {
    const TrivalentAtom& atom = network.atoms[atoms[k % size]];
    return atom.neighbour[slot_of_ring(atom, ring)] == no_atom;
  };
  std::size_t first = 0, open = 0, runs = 0;
  for (std::size_t k = 0; k < size; ++k) {
    open += is_open(k);
    if (is_open(k) && !is_open(k + size - 1)) {
      first = k;
      ++runs;
    }
  }
  if (runs != 1 || open > most_added || size < open + shortest_chain) return {};
  // Ring k of the link lies across the bond from atom k - 1 to atom k.
  const RingIndex from = link[first], to = link[(first + open) % size];
  if (from == to || network.rings[from].size <= shortest_chain || network.rings[to].size <= shortest_chain)
    return {};
  for (std::size_t k = open + 1; k < size; ++k)
    if (network.rings[link[(first + k) % size]].boundary) return {};
  NetworkEdit edit{NetworkEdit::Kind::open, {}, {{ring, -static_cast<int>(open)}, {from, -1}, {to, -1}}};
  edit.opened = ring;
  EditBuilder builder(network, edit);
  for (std::size_t k = 1; k < open; ++k) edit.rings.push_back({link[(first + k) % size], -2});
  for (std::size_t k = 0; k < open; ++k) builder.remove(atoms[(first + k) % size]);
  builder.rebond(atoms[(first + size - 1) % size], atoms[first], no_atom);
  builder.rebond(atoms[(first + open) % size], atoms[(first + open - 1) % size], no_atom);
  return edit;
}

}  // namespace nanocarbon::annealing
