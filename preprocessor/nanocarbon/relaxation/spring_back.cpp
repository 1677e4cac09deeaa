#include "nanocarbon/relaxation/spring_back.h"

#include "nanocarbon/relaxation/fixed_bond_model.h"

namespace nanocarbon {

namespace {

constexpr int kIterations = 800;
constexpr double kForceTolerance = 1e-2;  // eV/Angstrom

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
  for (const Vec3& p : positions) result.mean_distance += surface.distance(result.fit(p)) / count;
  return result;
}

}  // namespace nanocarbon
