// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/minimise_molecule.h"

#include <algorithm>
#include <optional>

#include "nanocarbon/core/neighbours_within.h"
#include "nanocarbon/core/space.h"
#include "nanocarbon/minimisation/apart_from.h"
#include "nanocarbon/minimisation/multilevel/sheet_preconditioner.h"

namespace nanocarbon::minimisation {

namespace {

const Cell* cell_of(const Molecule& molecule) { return molecule.cell ? &*molecule.cell : nullptr; }

// Whether a potential sees exactly the molecule's bonds.
bool bonds_are_those_seen(const Molecule& molecule, const BondCutoffs& cutoffs) {
  const NeighbourList near =
      neighbours_within(molecule.positions, cell_of(molecule), cutoffs.carbon_carbon.end);
  const Space space(molecule.cell);
  const auto distance = [&](AtomIndex a, AtomIndex b) {
    return space.displacement(molecule.positions[a], molecule.positions[b]).norm();
  };
  const auto& elements = molecule.elements;
  std::size_t seen = 0;
  for (AtomIndex a = 0; a < molecule.size(); ++a)
    for (const Neighbour& n : near.of(a))
      seen += a < n.atom && distance(a, n.atom) < apart_from(cutoffs, elements[a], elements[n.atom]);
  return seen == molecule.bonds.size() &&
         std::all_of(molecule.bonds.begin(), molecule.bonds.end(), [&](const Bond& bond) {
           return distance(bond.first, bond.second) <=
                  cutoffs.of(elements[bond.first], elements[bond.second]).begin;
         });
}

}  // namespace

EnergyFunction energy_of(const Molecule& molecule, potential::Potential& potential) {
  return [&](std::span<const Vec3> positions, std::span<Vec3> gradient) {
    const potential::Evaluation& result =
        potential.evaluate(positions, molecule.elements, cell_of(molecule), {});
    for (std::size_t a = 0; a < gradient.size(); ++a) gradient[a] -= result.forces[a];
    return result.energy;
  };
}

MinimisationResult minimise_molecule(Molecule& molecule, potential::Potential& potential,
                                     const MinimisationOptions& options) {
  std::optional<multilevel::SheetPreconditioner> preconditioner;
  if (molecule.size() >= multilevel::least_atoms) {
    preconditioner.emplace(Space(molecule.cell), molecule.positions,
                           multilevel::bonded_atoms(molecule.size(), molecule.bonds), options.team);
    preconditioner->renew(molecule.positions);
  }
  LbfgsOptions lbfgs{.max_iterations = options.max_iterations,
                     .force_tolerance = options.force_tolerance,
                     .preconditioner = preconditioner ? &*preconditioner : nullptr,
                     .team = options.team};
  if (options.stop)
    lbfgs.stop = [&](int iteration, double, std::span<const Vec3> x) { return options.stop(iteration, x); };
  const LbfgsResult relaxed = minimise_lbfgs(molecule.positions, energy_of(molecule, potential), lbfgs);
  return {relaxed.energy, relaxed.max_force, relaxed.iterations, relaxed.converged,
          bonds_are_those_seen(molecule, potential.bond_cutoffs())};
}

}  // namespace nanocarbon::minimisation
