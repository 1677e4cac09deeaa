// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/relax_structure.h"

#include <cmath>
#include <utility>

#include "nanocarbon/minimisation/lbfgs.h"

namespace nanocarbon::minimisation {

namespace {

//! A structure as it is after its edges have changed by factors.
void stretch(const Vec3& factors, std::optional<Cell>& cell) {
  if (!cell) return;
  cell->origin = cell->origin.cwiseProduct(factors);
  cell->vectors = factors.asDiagonal() * cell->vectors;
}

}  // namespace

MinimisationResult relax_structure(Molecule& structure, potential::Potential& potential,
                                   const FreeEdges& edges, const MinimisationOptions& options) {
  const std::size_t atoms = structure.size();
  // A strain costs as many times what one atom's displacement costs as there are atoms: this makes them alike.
  const double unit = std::sqrt(static_cast<double>(atoms));
  const auto factors = [&](const Vec3& strain) {
    Vec3 by = Vec3::Ones();
    for (int d = 0; d < 3; ++d)
      if (edges.free[d]) by[d] = std::exp(strain[d == 1 && edges.alike_across ? 0 : d] / unit);
    return by;
  };
  std::vector<Vec3> actual(atoms);
  const EnergyFunction energy = [&](std::span<const Vec3> at, std::span<Vec3> gradient) {
    const Vec3 by = factors(at[atoms]);
    std::optional<Cell> cell = structure.cell;
    stretch(by, cell);
    for (std::size_t i = 0; i < atoms; ++i) actual[i] = at[i].cwiseProduct(by);
    const potential::Evaluation& result =
        potential.evaluate(actual, structure.elements, cell ? &*cell : nullptr, {});
    for (std::size_t i = 0; i < atoms; ++i) gradient[i] -= result.forces[i].cwiseProduct(by);
    for (int d = 0; d < 3; ++d)
      if (edges.free[d]) gradient[atoms][d == 1 && edges.alike_across ? 0 : d] -= result.virial(d, d) / unit;
    return result.energy;
  };

  std::vector<Vec3> variables = structure.positions;
  variables.push_back(Vec3::Zero());
  const LbfgsResult relaxed =
      minimise_lbfgs(variables, energy,
                     {.max_iterations = options.max_iterations, .force_tolerance = options.force_tolerance});
  const Vec3 by = factors(variables.back());
  for (std::size_t i = 0; i < atoms; ++i) structure.positions[i] = variables[i].cwiseProduct(by);
  stretch(by, structure.cell);
  return {relaxed.energy, relaxed.max_force, relaxed.iterations, relaxed.converged};
}

}  // namespace nanocarbon::minimisation
