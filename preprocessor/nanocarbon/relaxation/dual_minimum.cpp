#include "nanocarbon/relaxation/dual_minimum.h"

#include "nanocarbon/relaxation/fixed_bond_model.h"

namespace nanocarbon {

Rebo2MinimisationResult minimise_dual(Molecule& molecule, const TetherSurface& surface,
                                      double force_tolerance) {
  relax_dual(molecule, surface);
  FixedBondModel model;
  model.rebo2.set_graph(fixed_bond_graph(molecule));
  minimise_fixed_bonds(model, nullptr, molecule.positions,
                       {.max_iterations = 2000, .force_tolerance = 3 * force_tolerance});
  return minimise_rebo2(molecule, {.force_tolerance = force_tolerance});
}

}  // namespace nanocarbon
