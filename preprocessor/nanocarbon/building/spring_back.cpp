// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/spring_back.h"

#include <utility>
#include <vector>

#include "nanocarbon/annealing/fixed_bond_model.h"
#include "nanocarbon/annealing/surface_fit.h"
#include "nanocarbon/building/potential_choice.h"
#include "nanocarbon/mesh/distance.h"
#include "nanocarbon/mesh/periodic_mesh.h"
#include "nanocarbon/molecule/ring_mesh.h"

namespace nanocarbon::building {

namespace {

constexpr int iterations = 3000;
constexpr double force_tolerance = 2e-3;  // eV/Angstrom

struct Apart {
  double there = 0, back = 0;  // Angstrom
};

Apart mean_distances(const annealing::TrivalentNetwork& network, const std::vector<Vec3>& positions,
                     const annealing::TetherSurface& surface) {
  Apart apart;
  for (const Vec3& p : positions) apart.there += surface.distance(p) / static_cast<double>(positions.size());
  const TriangleMesh rings = molecule::ring_mesh(annealing::molecule_of(network, positions, surface.space()));
  if (!rings.triangles.empty())
    apart.back = mesh::distances_of_area(surface.mesh(), rings, positions.size()).mean;
  return apart;
}

}  // namespace

Released spring_back(const annealing::SwitchingState& state, const annealing::TetherSurface& surface,
                     bool with_scale) {
  const auto timed = state.running.stage("released");
  const auto count = static_cast<double>(state.positions.size());
  annealing::FixedBondModel model;
  model.rebo2.set_graph(annealing::fixed_bond_graph(state.network, state.space));
  model.running = state.running;
  std::vector<Vec3> positions = state.positions;
  const minimisation::LbfgsResult released = annealing::minimise_fixed_bonds(
      model, nullptr, positions, {.max_iterations = iterations, .force_tolerance = force_tolerance});
  annealing::bring_back(positions, state.positions, !state.space.periodic());
  const annealing::Similarity fit =
      annealing::fit_to_surface(positions, surface, with_scale, state.running.team);
  for (Vec3& p : positions) p = fit(p);
  const Apart apart = mean_distances(state.network, positions, surface);
  return {.energy = released.energy / count, .mean_distance = apart.there, .left_out = apart.back};
}

Released spring_back_in_cell(const annealing::SwitchingState& state, const TriangleMesh& surface,
                             minimisation::CellRelaxation strains, Mat3& deformation) {
  const auto timed = state.running.stage("released");
  deformation.setIdentity();
  annealing::FixedBondModel model;
  model.running = state.running;
  model.rebo2.set_graph(annealing::fixed_bond_graph(state.network, state.space));
  std::vector<Vec3> positions = state.positions;
  annealing::minimise_fixed_bonds(model, nullptr, positions,
                                  {.max_iterations = 300, .force_tolerance = 20 * force_tolerance});
  Molecule molecule = annealing::molecule_of(state.network, positions, state.space);
  const std::unique_ptr<potential::Potential> potential = make_potential(PotentialChoice::rebo2);
  const minimisation::CellMinimum relaxed = minimisation::minimise_in_cell(
      molecule, *potential, strains, {.force_tolerance = force_tolerance, .max_iterations = iterations});
  if (!relaxed.minimum.intact) return spring_back(state, annealing::TetherSurface(surface, 1), false);
  deformation = relaxed.deformation;
  return released_in_cell(state.network, std::move(molecule.positions), state.positions, surface, deformation,
                          relaxed.minimum.energy / static_cast<double>(state.positions.size()));
}

Released released_in_cell(const annealing::TrivalentNetwork& network, std::vector<Vec3> positions,
                          std::vector<Vec3> held, TriangleMesh surface, const Mat3& deformation,
                          double energy) {
  mesh::deform(surface, deformation);
  const annealing::TetherSurface tether_surface(surface, 1);
  for (Vec3& p : held) p = deformation * p;
  annealing::bring_back(positions, held, false);
  const annealing::Similarity fit = annealing::fit_to_surface(positions, tether_surface, false);
  for (Vec3& p : positions) p = fit(p);
  const Apart apart = mean_distances(network, positions, tether_surface);
  return {.energy = energy, .mean_distance = apart.there, .left_out = apart.back};
}

}  // namespace nanocarbon::building
