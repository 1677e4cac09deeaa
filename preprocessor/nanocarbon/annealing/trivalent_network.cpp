// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/trivalent_network.h"

#include <fmt/format.h>

#include <algorithm>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/edge_table.h"

namespace nanocarbon::annealing {

namespace {

void find_ring_starts(TrivalentNetwork& network) {
  for (AtomIndex a = 0; a < network.atoms.size(); ++a)
    for (unsigned s = 0; s < 3; ++s) {
      TrivalentRing& ring = network.rings[network.atoms[a].ring[s]];
      ++ring.size;
      // Clockwise about the corner s lies the side (s, s + 1), which is opposite to s + 2.
      const bool first = network.atoms[a].neighbour[(s + 2) % 3] == no_atom;
      if (ring.atom == no_atom || first) ring.atom = a;
      ring.boundary |= first;
    }
}

// The mean of a boundary vertex's atoms lies inwards of it. It belongs where an atom between it and two rings
// is the centroid of its triangle or, without such an atom, as far beyond its atoms as the rings are before
// them.
void move_boundary_out(const TrivalentNetwork& network, std::span<const Vec3> positions, TriangleMesh& mesh) {
  struct Mean {
    Vec3 sum = Vec3::Zero();
    unsigned count = 0;
    void add(const Vec3& p) { sum += p, ++count; }
  };
  std::vector<Mean> centroid_rule(network.rings.size()), beyond(network.rings.size());
  for (AtomIndex a = 0; a < network.atoms.size(); ++a)
    for (unsigned s = 0; s < 3; ++s) {
      const RingIndex r = network.atoms[a].ring[s];
      if (!network.rings[r].boundary) continue;
      const RingIndex x = network.atoms[a].ring[(s + 1) % 3], y = network.atoms[a].ring[(s + 2) % 3];
      const Vec3 here = mesh.points[r], atom = mesh.space.beside(positions[a], here);
      const auto centre = [&](RingIndex ring) { return mesh.space.beside(mesh.points[ring], atom); };
      if (!network.rings[x].boundary && !network.rings[y].boundary)
        centroid_rule[r].add(3 * atom - centre(x) - centre(y));
      for (const RingIndex inner : {x, y})
        if (!network.rings[inner].boundary) beyond[r].add(2 * here - centre(inner));
    }
  for (RingIndex r = 0; r < network.rings.size(); ++r) {
    const Mean& mean = centroid_rule[r].count > 0 ? centroid_rule[r] : beyond[r];
    if (mean.count > 0) mesh.points[r] = mean.sum / mean.count;
  }
}

}  // namespace

TrivalentNetwork trivalent_network(const TriangleMesh& triangulation) {
  TrivalentNetwork network;
  network.rings.resize(triangulation.points.size());
  for (const Triangle& t : triangulation.triangles)
    network.atoms.push_back({{no_atom, no_atom, no_atom}, {t[0], t[1], t[2]}});
  const mesh::EdgeTable edges = mesh::edge_table(mesh::soup_of(triangulation));
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    if (uses.size() == 1) continue;
    if (uses.size() > 2 || uses[0].forward == uses[1].forward)
      throw UserError(
          Failure::unsuitable,
          fmt::format("the triangulation is not an oriented 2-manifold at the edge between vertices {} "
                      "and {}: {} triangles meet there. Repair the mesh first.",
                      edges.low[e], edges.high[e], uses.size()));
    for (const std::size_t i : {0, 1}) {
      const std::uint32_t opposite = (uses[i].corner + 2) % 3;
      network.atoms[uses[i].face].neighbour[opposite] = uses[1 - i].face;
    }
  }
  find_ring_starts(network);
  return network;
}

unsigned slot_of_neighbour(const TrivalentAtom& atom, AtomIndex neighbour) {
  for (unsigned s = 0; s < 3; ++s)
    if (atom.neighbour[s] == neighbour) return s;
  return 3;
}

unsigned slot_of_ring(const TrivalentAtom& atom, RingIndex ring) {
  for (unsigned s = 0; s < 3; ++s)
    if (atom.ring[s] == ring) return s;
  return 3;
}

void atoms_of_ring(const TrivalentNetwork& network, RingIndex ring, std::vector<AtomIndex>& atoms) {
  atoms.clear();
  const AtomIndex start = network.rings[ring].atom;
  AtomIndex at = start;
  do {
    atoms.push_back(at);
    const TrivalentAtom& atom = network.atoms[at];
    at = atom.neighbour[(slot_of_ring(atom, ring) + 1) % 3];
  } while (at != start && at != no_atom);
}

std::size_t atom_count(const TrivalentNetwork& network) {
  return static_cast<std::size_t>(std::count_if(network.atoms.begin(), network.atoms.end(),
                                                [](const TrivalentAtom& a) { return a.exists(); }));
}

std::vector<AtomIndex> compact(TrivalentNetwork& network) {
  std::vector<AtomIndex> former;
  std::vector<AtomIndex> new_atom(network.atoms.size(), no_atom);
  std::vector<RingIndex> new_ring(network.rings.size(), no_atom);
  AtomIndex atoms = 0;
  RingIndex rings = 0;
  for (AtomIndex a = 0; a < network.atoms.size(); ++a)
    if (network.atoms[a].exists()) new_atom[a] = atoms++;
  for (RingIndex r = 0; r < network.rings.size(); ++r)
    if (network.rings[r].size > 0) new_ring[r] = rings++;
  for (AtomIndex a = 0; a < network.atoms.size(); ++a) {
    if (new_atom[a] == no_atom) continue;
    TrivalentAtom atom = network.atoms[a];
    for (AtomIndex& n : atom.neighbour)
      if (n != no_atom) n = new_atom[n];
    for (RingIndex& r : atom.ring) r = new_ring[r];
    network.atoms[new_atom[a]] = atom;
    former.push_back(a);
  }
  for (RingIndex r = 0; r < network.rings.size(); ++r) {
    if (new_ring[r] == no_atom) continue;
    TrivalentRing ring = network.rings[r];
    ring.atom = new_atom[ring.atom];
    network.rings[new_ring[r]] = ring;
  }
  network.atoms.resize(atoms);
  network.rings.resize(rings);
  return former;
}

Molecule molecule_of(const TrivalentNetwork& network, std::span<const Vec3> positions, const Space& space) {
  Molecule molecule;
  if (space.periodic()) molecule.cell = *space.cell();
  molecule.positions.assign(positions.begin(), positions.end());
  molecule.elements.assign(positions.size(), Element::carbon);
  for (AtomIndex a = 0; a < network.atoms.size(); ++a)
    for (const AtomIndex n : network.atoms[a].neighbour)
      if (n != no_atom && n > a) molecule.bonds.push_back({a, n, space.image(positions[a], positions[n])});
  std::sort(molecule.bonds.begin(), molecule.bonds.end());
  std::vector<AtomIndex> cycle;
  for (RingIndex r = 0; r < network.rings.size(); ++r) {
    if (network.rings[r].boundary) continue;
    atoms_of_ring(network, r, cycle);
    molecule.rings.atoms.insert(molecule.rings.atoms.end(), cycle.begin(), cycle.end());
    molecule.rings.offsets.push_back(static_cast<std::uint32_t>(molecule.rings.atoms.size()));
  }
  return molecule;
}

TriangleMesh triangulation_of(const TrivalentNetwork& network, std::span<const Vec3> positions,
                              const Space& space) {
  TriangleMesh mesh;
  mesh.space = space;
  mesh.points.assign(network.rings.size(), Vec3::Zero());
  for (AtomIndex a = 0; a < network.atoms.size(); ++a) {
    const TrivalentAtom& atom = network.atoms[a];
    mesh.triangles.push_back({atom.ring[0], atom.ring[1], atom.ring[2]});
    for (const RingIndex r : atom.ring)
      mesh.points[r] += space.beside(positions[a], positions[network.rings[r].atom]) / network.rings[r].size;
  }
  move_boundary_out(network, positions, mesh);
  return mesh;
}

std::vector<std::size_t> ring_counts(const TrivalentNetwork& network) {
  std::vector<std::size_t> counts;
  for (const TrivalentRing& ring : network.rings) {
    if (ring.size == 0 || ring.boundary) continue;
    if (ring.size >= counts.size()) counts.resize(ring.size + 1, 0);
    ++counts[ring.size];
  }
  return counts;
}

}  // namespace nanocarbon::annealing
