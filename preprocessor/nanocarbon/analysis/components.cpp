// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/analysis/components.h"

#include <fmt/format.h>

#include <algorithm>

#include "nanocarbon/analysis/king_rings.h"
#include "nanocarbon/analysis/primitive_rings.h"
#include "nanocarbon/molecule/molecule_graph.h"

namespace nanocarbon::analysis {
namespace {

topology::EmbeddedGraph graph_of(const Molecule& molecule, std::span<const std::int64_t> ids) {
  topology::EmbeddedGraph graph = molecule::embedded_graph(molecule);
  graph.ids.assign(ids.begin(), ids.end());
  return graph;
}

void append(Rings& rings, std::span<const AtomIndex> ring) {
  rings.atoms.insert(rings.atoms.end(), ring.begin(), ring.end());
  rings.offsets.push_back(static_cast<std::uint32_t>(rings.atoms.size()));
}

// Rings of a part, whose atoms are those given.
void append(Rings& rings, const Rings& of_part, std::span<const AtomIndex> atoms) {
  std::vector<AtomIndex> ring;
  for (std::size_t r = 0; r < of_part.size(); ++r) {
    ring.clear();
    for (const AtomIndex a : of_part[r]) ring.push_back(atoms[a]);
    append(rings, ring);
  }
}

// The atoms of each component, in compressed rows.
struct Members {
  std::vector<std::uint32_t> offsets;
  std::vector<AtomIndex> atoms;
};

Members members_of(std::span<const std::uint32_t> of_atom, std::size_t components) {
  Members members;
  members.offsets.assign(components + 1, 0);
  for (const std::uint32_t p : of_atom) ++members.offsets[p + 1];
  for (std::size_t p = 0; p < components; ++p) members.offsets[p + 1] += members.offsets[p];
  members.atoms.resize(of_atom.size());
  std::vector<std::uint32_t> next(members.offsets.begin(), members.offsets.end() - 1);
  for (AtomIndex a = 0; a < of_atom.size(); ++a) members.atoms[next[of_atom[a]]++] = a;
  return members;
}

// One component's part of a graph; hydrogen that is bonded into another component as well has only its bonds in this one.
topology::EmbeddedGraph part_of(const topology::EmbeddedGraph& graph, std::span<const AtomIndex> atoms,
                                std::span<const std::uint32_t> of_atom, std::vector<AtomIndex>& place) {
  topology::EmbeddedGraph part;
  for (AtomIndex k = 0; k < atoms.size(); ++k) place[atoms[k]] = k;
  for (const AtomIndex a : atoms) {
    for (std::uint32_t h = graph.offsets[a]; h < graph.offsets[a + 1]; ++h)
      if (of_atom[graph.ends[h]] == of_atom[a]) {
        part.ends.push_back(place[graph.ends[h]]);
        part.vectors.push_back(graph.vectors[h]);
      }
    part.offsets.push_back(static_cast<std::uint32_t>(part.ends.size()));
    part.elements.push_back(graph.elements[a]);
    part.ids.push_back(graph.id(a));
  }
  return part;
}

void take_surfaces_one_by_one(const topology::EmbeddedGraph& graph, const ComponentOptions& options,
                              MoleculeComponents& result) {
  const Members members = members_of(result.of_atom, result.list.size());
  std::vector<AtomIndex> place(graph.atoms());
  for (std::size_t p = 0; p < result.list.size(); ++p) {
    const std::span<const AtomIndex> atoms(members.atoms.data() + members.offsets[p],
                                           members.offsets[p + 1] - members.offsets[p]);
    const topology::SurfaceTopology surface =
        topology::surface_topology(part_of(graph, atoms, result.of_atom, place), {options.max_ring});
    MoleculeComponent& component = result.list[p];
    if (surface.problem) {
      component.not_a_surface = surface.problem->reason;
      continue;
    }
    component.topology = surface.components.front();
    append(result.rings, surface.rings, atoms);
    append(result.holes, surface.holes, atoms);
  }
}

// Bonds of the components that the rings are searched in.
BondRows rows_of_components(const Molecule& molecule, const MoleculeComponents& components,
                            bool only_without_surface) {
  Molecule part;
  part.positions = molecule.positions;
  part.elements = molecule.elements;
  for (const Bond& bond : molecule.bonds)
    if (!only_without_surface || !components.list[components.of_atom[bond.first]].is_surface())
      part.bonds.push_back(bond);
  return carbon_bond_rows(part);
}

void search_rings(const Molecule& molecule, const topology::EmbeddedGraph& graph,
                  const ComponentOptions& options, MoleculeComponents& result) {
  const bool automatic = options.rings == RingChoice::automatic;
  const BondRows rows = rows_of_components(molecule, result, automatic);
  const auto kind = options.rings == RingChoice::primitive ? RingKind::primitive : RingKind::king;
  if (!automatic) result.rings = {};
  const std::optional<AtomIndex> crowded = crowded_atom(rows);
  for (MoleculeComponent& component : result.list)
    if (!automatic || !component.is_surface()) component.rings = crowded ? RingKind::none : kind;
  if (crowded) {
    result.rings_not_counted = fmt::format(
        "rings are not searched for, because atom ID {} has {} bonds; are its distances Angstrom?",
        graph.id(*crowded), rows.degree(*crowded));
    return;
  }
  result.atoms_searched = automatic ? result.atoms_without_surface : molecule.size();
  const RingSearchOptions search{options.max_ring, options.threads};
  RingStatistics king = king_rings(rows, search);
  RingStatistics primitive = primitive_rings(rows, search);
  result.king_counts = std::move(king.counts);
  result.primitive_counts = std::move(primitive.counts);
  const Rings& found = kind == RingKind::primitive ? primitive.rings : king.rings;
  for (std::size_t r = 0; r < found.size(); ++r) append(result.rings, found[r]);
}

}  // namespace

std::string_view name(RingKind kind) {
  switch (kind) {
    case RingKind::faces:
      return "faces";
    case RingKind::king:
      return "king";
    case RingKind::primitive:
      return "primitive";
    case RingKind::none:
      break;
  }
  return "none";
}

MoleculeComponents find_components(const Molecule& molecule, std::span<const std::int64_t> ids,
                                   const ComponentOptions& options) {
  MoleculeComponents result;
  const topology::EmbeddedGraph graph = graph_of(molecule, ids);
  result.surface = topology::surface_topology(graph, {options.max_ring});
  result.of_atom = result.surface.component_of_atom;
  result.list.resize(result.surface.components.size());
  for (AtomIndex a = static_cast<AtomIndex>(molecule.size()); a-- > 0;) {
    MoleculeComponent& component = result.list[result.of_atom[a]];
    component.first = a;
    ++component.atoms;
  }
  if (!result.surface.problem) {
    for (std::size_t p = 0; p < result.list.size(); ++p)
      result.list[p].topology = result.surface.components[p];
    result.rings = result.surface.rings;
    result.holes = result.surface.holes;
  } else if (result.list.size() == 1) {
    result.list[0].not_a_surface = result.surface.problem->reason;
  } else {
    take_surfaces_one_by_one(graph, options, result);
  }
  const bool automatic = options.rings == RingChoice::automatic;
  for (const MoleculeComponent& component : result.list)
    if (!component.is_surface()) result.atoms_without_surface += component.atoms;
  if (!automatic || !result.all_surfaces()) search_rings(molecule, graph, options, result);
  result.ring_counts.assign(static_cast<std::size_t>(options.max_ring) + 1, 0);
  for (std::size_t r = 0; r < result.rings.size(); ++r) ++result.ring_counts[result.rings[r].size()];
  return result;
}

}  // namespace nanocarbon::analysis
