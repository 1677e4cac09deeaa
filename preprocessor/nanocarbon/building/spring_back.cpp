// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/spring_back.h"

#include "nanocarbon/annealing/fixed_bond_model.h"
#include "nanocarbon/annealing/surface_fit.h"

namespace nanocarbon::building {

namespace {

constexpr int iterations = 3000;
constexpr double force_tolerance = 2e-3;  // eV/Angstrom

}  // namespace

Released spring_back(const annealing::SwitchingState& state, const annealing::TetherSurface& surface,
                     bool with_scale) {
  const auto count = static_cast<double>(state.positions.size());
  annealing::FixedBondModel model;
  model.rebo2.set_graph(annealing::fixed_bond_graph(state.network, state.space));
  std::vector<Vec3> positions = state.positions;
  const minimisation::LbfgsResult released = annealing::minimise_fixed_bonds(
      model, nullptr, positions, {.max_iterations = iterations, .force_tolerance = force_tolerance});
  Released result;
  result.energy = released.energy / count;
  const annealing::Similarity fit = annealing::fit_to_surface(positions, surface, with_scale);
  for (const Vec3& p : positions) result.mean_distance += surface.distance(fit(p)) / count;
  return result;
}

}  // namespace nanocarbon::building
