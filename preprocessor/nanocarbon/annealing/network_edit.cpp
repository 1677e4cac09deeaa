// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/network_edit.h"

#include <algorithm>

namespace nanocarbon::annealing {

TrivalentAtom& EditBuilder::record(AtomIndex atom) {
  for (NetworkEdit::AtomChange& change : edit_.atoms)
    if (change.atom == atom) return change.record;
  edit_.atoms.push_back({atom, network_.atoms[atom]});
  return edit_.atoms.back().record;
}

void EditBuilder::remove(AtomIndex atom) {
  add(atom, {{no_atom, no_atom, no_atom}, {no_atom, no_atom, no_atom}});
  ++edit_.removed;
}

void EditBuilder::rebond(AtomIndex atom, AtomIndex from, AtomIndex to) {
  if (atom == no_atom) return;
  TrivalentAtom& changed = record(atom);
  changed.neighbour[slot_of_neighbour(changed, from)] = to;
}

void EditBuilder::relabel(AtomIndex atom, RingIndex from, RingIndex to) {
  TrivalentAtom& changed = record(atom);
  changed.ring[slot_of_ring(changed, from)] = to;
}

void link_of(const TrivalentNetwork& network, RingIndex ring, std::vector<AtomIndex>& atoms,
             std::vector<RingIndex>& link) {
  atoms_of_ring(network, ring, atoms);
  link.clear();
  for (const AtomIndex a : atoms)
    link.push_back(network.atoms[a].ring[(slot_of_ring(network.atoms[a], ring) + 1) % 3]);
  if (!network.rings[ring].boundary) return;
  const TrivalentAtom& last = network.atoms[atoms.back()];
  link.push_back(last.ring[(slot_of_ring(last, ring) + 2) % 3]);
}

namespace {

// A bond i-j with what surrounds it: triangles i = (c, a, b) and j = (d, b, a).
struct BondPlace {
  AtomIndex i, j;
  RingIndex a, b, c, d;
  AtomIndex across_ca, across_bc, across_ad, across_db;
};

std::optional<BondPlace> place_of(const TrivalentNetwork& network, AtomIndex atom, unsigned s) {
  const TrivalentAtom& i = network.atoms[atom];
  if (i.neighbour[s] == no_atom) return {};
  const TrivalentAtom& j = network.atoms[i.neighbour[s]];
  const unsigned t = slot_of_neighbour(j, atom);
  const BondPlace place{atom,
                        i.neighbour[s],
                        i.ring[(s + 1) % 3],
                        i.ring[(s + 2) % 3],
                        i.ring[s],
                        j.ring[t],
                        i.neighbour[(s + 2) % 3],
                        i.neighbour[(s + 1) % 3],
                        j.neighbour[(t + 1) % 3],
                        j.neighbour[(t + 2) % 3]};
  const std::array atoms = {place.i,         place.j,         place.across_ca,
                            place.across_bc, place.across_ad, place.across_db};
  for (std::size_t m = 0; m < atoms.size(); ++m)
    for (std::size_t n = 0; n < m; ++n)
      if (atoms[m] != no_atom && atoms[m] == atoms[n]) return {};
  if (place.c == place.d || place.a == place.b) return {};
  return place;
}

// Whether a ring or chain may lose an atom.
bool may_shrink(const TrivalentRing& ring) { return !ring.boundary || ring.size > shortest_chain; }

}  // namespace

std::optional<NetworkEdit> flip_bond(const TrivalentNetwork& network, AtomIndex atom, unsigned slot) {
  const auto place = place_of(network, atom, slot);
  if (!place) return {};
  const auto& [i, j, a, b, c, d, ca, bc, ad, db] = *place;
  if (!may_shrink(network.rings[a]) || !may_shrink(network.rings[b])) return {};
  if (network.rings[c].boundary && network.rings[d].boundary) return {};
  std::vector<AtomIndex> atoms;
  std::vector<RingIndex> link;
  link_of(network, c, atoms, link);
  if (std::find(link.begin(), link.end(), d) != link.end()) return {};
  NetworkEdit edit{NetworkEdit::Kind::flip, {}, {{a, -1}, {b, -1}, {c, 1}, {d, 1}}};
  edit.centre = {i, j};
  EditBuilder builder(network, edit);
  builder.add(i, {{ad, j, ca}, {c, a, d}});
  builder.add(j, {{bc, i, db}, {d, b, c}});
  builder.rebond(ad, j, i);
  builder.rebond(bc, i, j);
  return edit;
}

std::optional<NetworkEdit> collapse_bond(const TrivalentNetwork& network, AtomIndex atom, unsigned slot) {
  const auto place = place_of(network, atom, slot);
  if (!place) return {};
  const auto& [i, j, a, b, c, d, ca, bc, ad, db] = *place;
  if (network.rings[a].boundary || network.rings[b].boundary) return {};
  if (!may_shrink(network.rings[c]) || !may_shrink(network.rings[d])) return {};
  std::vector<AtomIndex> atoms;
  std::vector<RingIndex> link_a, link_b;
  link_of(network, a, atoms, link_a);
  link_of(network, b, atoms, link_b);
  // The link condition (Dey, Edelsbrunner et al. 1999): only c and d neighbour both.
  for (const RingIndex r : link_a)
    if (r != c && r != d && std::find(link_b.begin(), link_b.end(), r) != link_b.end()) return {};
  const int size_b = static_cast<int>(network.rings[b].size);
  NetworkEdit edit{NetworkEdit::Kind::collapse, {}, {{a, size_b - 4}, {b, -size_b}, {c, -1}, {d, -1}}};
  edit.centre = {i, j};
  EditBuilder builder(network, edit);
  builder.rebond(ca, i, bc);
  builder.rebond(bc, i, ca);
  builder.rebond(ad, j, db);
  builder.rebond(db, j, ad);
  for (const AtomIndex member : atoms)  // of ring b, listed last
    if (member != i && member != j) builder.relabel(member, b, a);
  builder.remove(i);
  builder.remove(j);
  return edit;
}

std::optional<NetworkEdit> split_ring(const TrivalentNetwork& network, RingIndex ring, unsigned first,
                                      unsigned count) {
  if (network.rings[ring].boundary) return {};
  std::vector<AtomIndex> atoms;
  std::vector<RingIndex> link;
  link_of(network, ring, atoms, link);
  const std::size_t size = atoms.size();
  const AtomIndex p_before = atoms[first % size], p_after = atoms[(first + 1) % size];
  const AtomIndex q_before = atoms[(first + count) % size], q_after = atoms[(first + count + 1) % size];
  const auto ring_across = [&](AtomIndex before) {  // the ring on the other side of the bond to the next atom
    const TrivalentAtom& record = network.atoms[before];
    return record.ring[(slot_of_ring(record, ring) + 2) % 3];
  };
  const RingIndex p = ring_across(p_before), q = ring_across(q_before);
  if (p == q) return {};
  const int moved = static_cast<int>(count);
  const RingIndex added_ring = added_rings[0];
  NetworkEdit edit{
      NetworkEdit::Kind::split, {}, {{ring, 2 - moved}, {added_ring, moved + 2}, {p, 1}, {q, 1}}};
  edit.added = 2;
  edit.rings_added = 1;
  edit.centre = {added_atoms[0], added_atoms[1]};
  EditBuilder builder(network, edit);
  const AtomIndex u = added_atoms[0], w = added_atoms[1];
  builder.rebond(p_before, p_after, u);
  builder.rebond(p_after, p_before, u);
  builder.rebond(q_before, q_after, w);
  builder.rebond(q_after, q_before, w);
  for (unsigned k = 1; k <= count; ++k) builder.relabel(atoms[(first + k) % size], ring, added_ring);
  builder.add(u, {{p_after, w, p_before}, {ring, p, added_ring}});
  builder.add(w, {{q_after, u, q_before}, {added_ring, q, ring}});
  return edit;
}

namespace {

template <class Index, class Entry>
Index taken_entry(std::vector<Index>& free, std::vector<Entry>& entries, const Entry& unused) {
  if (free.empty()) {
    free.push_back(static_cast<Index>(entries.size()));
    entries.push_back(unused);
  }
  const Index entry = free.back();
  free.pop_back();
  return entry;
}

}  // namespace

CommittedEdit commit_edit(TrivalentNetwork& network, const NetworkEdit& edit,
                          std::vector<AtomIndex>& free_atoms, std::vector<RingIndex>& free_rings) {
  CommittedEdit made;
  made.atoms.fill(no_atom);
  made.rings.fill(no_atom);
  const TrivalentAtom unused = {{no_atom, no_atom, no_atom}, {no_atom, no_atom, no_atom}};
  for (int k = 0; k < edit.added; ++k)
    made.atoms[static_cast<std::size_t>(k)] = taken_entry(free_atoms, network.atoms, unused);
  for (int k = 0; k < edit.rings_added; ++k) {
    const RingIndex r = taken_entry(free_rings, network.rings, TrivalentRing{});
    made.rings[static_cast<std::size_t>(k)] = r;
    network.rings[r] = {0, no_atom, edit.new_rings_open};
  }
  if (edit.opened != no_atom) network.rings[edit.opened].boundary = true;
  if (edit.closed != no_atom) network.rings[edit.closed].boundary = false;
  for (const auto& [ring, change] : edit.rings) {
    TrivalentRing& changed = network.rings[made.ring_entry(ring)];
    changed.size = static_cast<std::uint32_t>(static_cast<int>(changed.size) + change);
    if (changed.size > 0) continue;
    changed.boundary = false;
    free_rings.push_back(ring);
  }
  for (const auto& [atom, record] : edit.atoms) {
    const AtomIndex a = made.entry(atom);
    TrivalentAtom& changed = network.atoms[a];
    changed = record;
    if (!changed.exists()) {
      free_atoms.push_back(a);
      continue;
    }
    for (AtomIndex& n : changed.neighbour) n = made.entry(n);
    for (RingIndex& r : changed.ring) r = made.ring_entry(r);
    for (unsigned s = 0; s < 3; ++s) {
      TrivalentRing& ring = network.rings[changed.ring[s]];
      // Of a chain on the boundary the first, which has nothing clockwise of it.
      if (!ring.boundary || changed.neighbour[(s + 2) % 3] == no_atom) ring.atom = a;
    }
  }
  return made;
}

}  // namespace nanocarbon::annealing
