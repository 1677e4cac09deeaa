// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/general_evaluation.h"

#include "nanocarbon/potential/airebo/long_range.h"

namespace nanocarbon::airebo {

using potential::AtomShares;
using potential::AtomsView;
using potential::NearPairs;
using rebo2::HalfEdges;

namespace {

//! Calls visit(term) for each pair within reach that E_LJ acts on. \param edges with the bonds of own atoms,
//! of their neighbours and of theirs
template <class Visit>
void for_each_pair(const AtomsView& atoms, const NearPairs& pairs, const AireboModel& model, HalfEdges& edges,
                   BondPaths& paths, Visit&& visit) {
  for (std::uint32_t i = 0; i < atoms.own; ++i) {
    paths.find(edges, i);
    const Eigen::Map<const Vec3> from(atoms.positions + 3 * std::size_t{i});
    for (const std::uint32_t j : pairs.of(i)) {
      const double cutoff = lj_reach(model.lj, rebo2::pair_index(atoms.elements[i], atoms.elements[j]));
      const Eigen::Map<const Vec3> to(atoms.positions + 3 * std::size_t{j});
      if (!((to - from).squaredNorm() < cutoff * cutoff)) continue;
      LongRangeTerm term = {.i = i, .j = j};
      if (const BondPath* path = paths.to(j)) {
        if (path->weight == 1.0) continue;
        term.path = *path;
      }
      visit(term);
    }
  }
}

}  // namespace

AireboEnergyParts evaluate_general(const AtomsView& atoms, const NearPairs& near, const NearPairs& pairs,
                                   const AireboModel& model, AireboWorkspace& workspace, double* forces,
                                   const AtomShares& shares) {
  HalfEdges& edges = workspace.rebo.edges;
  rebo2::collect_bonds(atoms, near, model.parameters.rebo, edges);
  if (model.terms.long_range)
    for_each_pair(atoms, pairs, model, edges, workspace.paths,
                  [&](const LongRangeTerm& term) { add_bonds_for(term, atoms, near, model, edges); });
  AireboEnergyParts energy;
  energy.bonds = rebo2::add_general_terms(atoms, model.rebo, workspace.rebo, shares);
  if (model.terms.long_range)
    for_each_pair(atoms, pairs, model, edges, workspace.paths, [&](const LongRangeTerm& term) {
      energy.long_range +=
          add_long_range_term(term, atoms, model, edges, workspace.hypothetical, forces, shares);
    });
  edges.add_forces(forces);
  return energy;
}

}  // namespace nanocarbon::airebo
