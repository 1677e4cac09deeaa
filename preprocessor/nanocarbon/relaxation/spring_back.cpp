#include "nanocarbon/relaxation/spring_back.h"

#include "nanocarbon/relaxation/fixed_bond_model.h"

namespace nanocarbon {

namespace {

constexpr int kIterations = 800;
constexpr double kForceTolerance = 1e-2;  // eV/Angstrom
constexpr int kSmoothing = 20;            // sweeps: about four bonds
// Of the spring-back that is held against. All of it would overshoot: bending springs back whatever the
// bonds.
constexpr double kShare = 0.7;

std::vector<double> smoothed(std::vector<double> values, const TrivalentNetwork& network) {
  std::vector<double> next(values.size());
  for (int sweep = 0; sweep < kSmoothing; ++sweep) {
    for (std::size_t a = 0; a < values.size(); ++a) {
      double sum = values[a], count = 1;
      for (const AtomIndex n : network.atoms[a].neighbour)
        if (n != no_atom) {
          sum += values[n];
          ++count;
        }
      next[a] = sum / count;
    }
    values.swap(next);
  }
  return values;
}

}  // namespace

SpringBack spring_back(const SwitchingState& state, const TetherSurface& surface, bool with_scale) {
  const auto count = static_cast<double>(state.positions.size());
  FixedBondModel model;
  model.rebo2.set_graph(fixed_bond_graph(state.network));
  std::vector<Vec3> positions = state.positions;
  const LbfgsResult released = minimise_fixed_bonds(
      model, nullptr, positions, {.max_iterations = kIterations, .force_tolerance = kForceTolerance});
  SpringBack result;
  result.energy = released.energy / count;
  result.fit = fit_to_surface(positions, surface, with_scale);
  for (const Vec3& p : positions) {
    const Vec3 x = result.fit(p);
    result.heights.push_back(height_above(surface.plane_at(x), x));
    result.mean_distance += surface.distance(x) / count;
  }
  result.heights = smoothed(std::move(result.heights), state.network);
  return result;
}

void compensate(SwitchingState& state, const SpringBack& spring_back) {
  state.lift.resize(state.positions.size(), 0);
  for (std::size_t a = 0; a < state.positions.size(); ++a) state.lift[a] -= kShare * spring_back.heights[a];
  state.planes.clear();
}

}  // namespace nanocarbon
