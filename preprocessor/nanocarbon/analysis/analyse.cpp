// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/analysis/analyse.h"

#include <algorithm>

namespace nanocarbon::analysis {
namespace {

// Atoms of components whose faces run the same way round everywhere.
std::vector<std::uint8_t> oriented_atoms(const Molecule& molecule, const MoleculeComponents& components) {
  std::vector<std::uint8_t> oriented(molecule.size(), 0);
  for (AtomIndex a = 0; a < molecule.size(); ++a) {
    const MoleculeComponent& component = components.list[components.of_atom[a]];
    oriented[a] =
        component.is_surface() && component.rings == RingKind::faces && component.topology.orientable;
  }
  return oriented;
}

}  // namespace

RingsOfAtoms rings_of_atoms(std::size_t atoms, const Rings& rings) {
  RingsOfAtoms result;
  result.offsets.assign(atoms + 1, 0);
  for (const AtomIndex a : rings.atoms) ++result.offsets[a + 1];
  for (std::size_t a = 0; a < atoms; ++a) result.offsets[a + 1] += result.offsets[a];
  result.rings.resize(rings.atoms.size());
  std::vector<std::uint32_t> next(result.offsets.begin(), result.offsets.end() - 1);
  for (std::uint32_t r = 0; r < rings.size(); ++r)
    for (const AtomIndex a : rings[r]) result.rings[next[a]++] = r;
  for (std::size_t a = 0; a < atoms; ++a)
    std::stable_sort(result.rings.begin() + result.offsets[a], result.rings.begin() + result.offsets[a + 1],
                     [&](std::uint32_t x, std::uint32_t y) { return rings[x].size() < rings[y].size(); });
  return result;
}

Analysis analyse(const Molecule& molecule, std::span<const std::int64_t> ids, const AnalyseOptions& options) {
  constexpr double angle_bin = 1.0, mean_bin = 0.005, gaussian_bin = 0.0005;
  Analysis result;
  result.rows = bond_rows(molecule);
  result.components = find_components(molecule, ids, options.components);
  result.bonds = bond_distributions(molecule, result.rows);
  result.rings_of_atoms = rings_of_atoms(molecule.size(), result.components.rings);
  result.geometry = atom_geometry(molecule, result.rows, result.components.rings,
                                  oriented_atoms(molecule, result.components));
  result.pyramidalisation = distribution(result.geometry.pyramidalisation, angle_bin);
  result.mean_curvature = distribution(result.geometry.mean_curvature, mean_bin);
  result.gaussian_curvature = distribution(result.geometry.gaussian_curvature, gaussian_bin);
  result.defects = find_defects(molecule, result.rows, result.components);
  if (options.potential && molecule.size() > 0) {
    const potential::Evaluation& evaluation =
        options.potential->evaluate(molecule.positions, molecule.elements,
                                    molecule.cell ? &*molecule.cell : nullptr, {.atom_energies = true});
    result.energy = evaluation.energy;
    result.atom_energies = evaluation.atom_energies;
    result.potential = options.potential->name();
  }
  return result;
}

}  // namespace nanocarbon::analysis
