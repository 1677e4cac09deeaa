#include "nanocarbon/relaxation/spring_back.h"

#include "nanocarbon/relaxation/fixed_bond_model.h"
#include "nanocarbon/relaxation/surface_fit.h"

namespace nanocarbon {

namespace {

constexpr int kIterations = 3000;
constexpr double kForceTolerance = 2e-3;  // eV/Angstrom

}  // namespace

Released spring_back(const SwitchingState& state, const TetherSurface& surface, bool with_scale) {
  const auto count = static_cast<double>(state.positions.size());
  FixedBondModel model;
  model.rebo2.set_graph(fixed_bond_graph(state.network));
  std::vector<Vec3> positions = state.positions;
  const LbfgsResult released = minimise_fixed_bonds(
      model, nullptr, positions, {.max_iterations = kIterations, .force_tolerance = kForceTolerance});
  Released result;
  result.energy = released.energy / count;
  const Similarity fit = fit_to_surface(positions, surface, with_scale);
  for (const Vec3& p : positions) result.mean_distance += surface.distance(fit(p)) / count;
  return result;
}

}  // namespace nanocarbon
