// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/structures/close_bonds.h"

#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/molecule_graph.h"
#include "nanocarbon/topology/bond_graph.h"
#include "nanocarbon/topology/surface_topology.h"

namespace nanocarbon::structures {

void add_bonds(Molecule& molecule) {
  molecule.bonds = topology::bonds_within(molecule.positions, molecule.elements,
                                          molecule.cell ? &*molecule.cell : nullptr);
}

void add_rings(Molecule& molecule, int largest) {
  topology::SurfaceTopology surface =
      topology::surface_topology(molecule::embedded_graph(molecule), {largest});
  if (surface.problem)
    throw UserError(Failure::failed, "the structure is not a surface: " + surface.problem->reason);
  molecule.rings = std::move(surface.rings);
}

Molecule without_dangling_atoms(const Molecule& molecule) {
  const std::size_t n = molecule.size();
  std::vector<std::uint32_t> degree(n, 0), start(n + 1, 0);
  for (const Bond& b : molecule.bonds) ++degree[b.first], ++degree[b.second];
  for (std::size_t i = 0; i < n; ++i) start[i + 1] = start[i] + degree[i];
  std::vector<AtomIndex> partner(start[n]);
  std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
  for (const Bond& b : molecule.bonds) {
    partner[fill[b.first]++] = b.second;
    partner[fill[b.second]++] = b.first;
  }

  std::vector<AtomIndex> dangling;
  std::vector<bool> removed(n, false);
  const auto drop = [&](AtomIndex atom) {
    removed[atom] = true;
    dangling.push_back(atom);
  };
  for (AtomIndex i = 0; i < n; ++i)
    if (degree[i] < 2) drop(i);
  while (!dangling.empty()) {
    const AtomIndex atom = dangling.back();
    dangling.pop_back();
    for (std::uint32_t k = start[atom]; k < start[atom + 1]; ++k)
      if (!removed[partner[k]] && --degree[partner[k]] < 2) drop(partner[k]);
  }

  Molecule kept;
  kept.cell = molecule.cell;
  std::vector<AtomIndex> index(n, 0);
  for (AtomIndex i = 0; i < n; ++i) {
    if (removed[i]) continue;
    index[i] = static_cast<AtomIndex>(kept.size());
    kept.positions.push_back(molecule.positions[i]);
    kept.elements.push_back(molecule.elements[i]);
  }
  for (const Bond& b : molecule.bonds)
    if (!removed[b.first] && !removed[b.second])
      kept.bonds.push_back({index[b.first], index[b.second], b.image});
  return kept;
}

}  // namespace nanocarbon::structures
