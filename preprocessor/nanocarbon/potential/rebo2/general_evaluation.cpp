// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/general_evaluation.h"

#include "nanocarbon/potential/rebo2/conjugation.h"

namespace nanocarbon::rebo2 {

void collect_bonds(const potential::AtomsView& atoms, const potential::NearPairs& near,
                   const Rebo2Parameters& parameters, HalfEdges& edges) {
  edges.clear(atoms.all);
  for (std::uint32_t i = 0; i < atoms.own; ++i) edges.add(i, atoms, near, parameters);
  for (std::uint32_t i = 0; i < atoms.own; ++i) {
    const Centre centre = edges.centre(i);
    for (std::uint32_t a = 0; a < centre.count; ++a) {
      const std::uint32_t j = edges.of(centre)[a].to;
      if (j < atoms.own) continue;
      edges.add(j, atoms, near, parameters);
      const Centre copy = edges.centre(j);
      for (std::uint32_t b = 0; b < copy.count; ++b) edges.add(edges.of(copy)[b].to, atoms, near, parameters);
    }
  }
}

EnergyParts add_general_terms(const potential::AtomsView& atoms, const Model& model,
                              GeneralWorkspace& workspace, const potential::AtomShares& shares) {
  HalfEdges& edges = workspace.edges;
  EnergyParts energy;
  for (std::uint32_t i = 0; i < atoms.own; ++i)
    energy += add_centre_terms(edges, edges.centre(i), model, workspace.angles, shares);
  for (std::uint32_t i = 0; i < atoms.own; ++i) {
    const Centre& centre = edges.centre(i);
    for (HalfEdge& ij : edges.of(centre)) {
      if (ij.to < i) continue;
      const double share = ij.to < atoms.own ? 1.0 : 0.5;
      energy += add_bond_terms(edges, centre, ij, model, share, shares);
    }
  }
  return energy;
}

EnergyParts evaluate_general(const potential::AtomsView& atoms, const potential::NearPairs& near,
                             const Model& model, GeneralWorkspace& workspace, double* forces,
                             const potential::AtomShares& shares) {
  collect_bonds(atoms, near, model.parameters, workspace.edges);
  const EnergyParts energy = add_general_terms(atoms, model, workspace, shares);
  workspace.edges.add_forces(forces);
  return energy;
}

}  // namespace nanocarbon::rebo2
