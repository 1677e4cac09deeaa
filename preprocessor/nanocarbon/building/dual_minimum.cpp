// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/dual_minimum.h"

#include "nanocarbon/annealing/fixed_bond_model.h"

namespace nanocarbon::building {

minimisation::MinimisationResult minimise_dual(Molecule& molecule, potential::Potential& potential,
                                               const annealing::TetherSurface& surface,
                                               double force_tolerance) {
  annealing::relax_dual(molecule, surface);
  annealing::FixedBondModel model;
  model.rebo2.set_graph(annealing::fixed_bond_graph(molecule));
  annealing::minimise_fixed_bonds(model, nullptr, molecule.positions,
                                  {.max_iterations = 2000, .force_tolerance = 3 * force_tolerance});
  return minimisation::minimise_molecule(molecule, potential, {.force_tolerance = force_tolerance});
}

}  // namespace nanocarbon::building
