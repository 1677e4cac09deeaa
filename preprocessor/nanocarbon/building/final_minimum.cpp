// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/final_minimum.h"

#include <span>
#include <utility>
#include <vector>

#include "nanocarbon/annealing/fixed_bond_model.h"
#include "nanocarbon/annealing/geometry_check.h"
#include "nanocarbon/annealing/surface_fit.h"
#include "nanocarbon/annealing/unknot.h"
#include "nanocarbon/building/annealing_schedules.h"
#include "nanocarbon/building/potential_choice.h"
#include "nanocarbon/building/pressed_watch.h"
#include "nanocarbon/building/turn_components.h"
#include "nanocarbon/mesh/periodic_mesh.h"
#include "nanocarbon/molecule/hydrogens.h"

namespace nanocarbon::building {

namespace {

constexpr int mendings = 2;

// Forces that are left on fixed bonds before the full potential takes over, over those left in the end. It is
// as safe for the rest of the way and faster; where it was not, once more from nearer.
constexpr double left_on_fixed_bonds = 50, left_once_mended = 3;

// For large molecules fixed bonds are much faster: nothing is left where the full potential has no other minimum.
constexpr std::size_t least_large = 2000;
constexpr double left_of_large = 1;

// Of the tolerance of forces, where strains are free: they weigh so little in the gradient that up to 1e-3 GPa of stress
// would be left in cells of 200 atoms.
constexpr double left_in_cell = 0.25;

struct Descent {
  Molecule molecule;
  minimisation::CellMinimum end;
};

// Fixed bonds do not see that hydrogens meet, as at both sides of a bay. AIREBO binds those that begin within 1.28
// Angstrom of each other; REBO2 parts them from 1.1 on.
void part_hydrogens(Molecule& molecule) {
  minimisation::minimise_molecule(molecule, *make_potential(PotentialChoice::rebo2),
                                  {.force_tolerance = 0.1, .max_iterations = 200});
}

// Without the tether, first on fixed bonds: the way to the minimum may stretch bonds that the end does not. May give up
// where another try follows that mends what is wrong with this one.
Descent descend(const annealing::AnnealingLevel& level, const TriangleMesh& surface, double left,
                bool may_give_up, potential::Potential& potential, const AnnealOptions& options) {
  annealing::FixedBondModel model;
  model.running = options.running;
  model.rebo2.set_graph(annealing::fixed_bond_graph(level.state.network, level.state.space));
  std::vector<Vec3> positions = level.state.positions;
  {
    const auto timed = options.running.stage("free");
    annealing::minimise_fixed_bonds(
        model, nullptr, positions,
        {.max_iterations = 2000, .force_tolerance = left * options.force_tolerance});
  }
  const auto timed = options.running.stage("minimum");
  Molecule molecule = annealing::molecule_of(level.state.network, positions, level.state.space);
  // REBO2 does not feel how sheets lie on each other.
  if (potential.unbonded_reach() > 0 && !molecule.cell)
    turn_components(molecule.positions, topology::connected_components(molecule.size(), molecule.bonds),
                    surface, options.seed);
  if (options.hydrogen) {
    const std::size_t carbons = molecule.size();
    molecule = molecule::saturated_with_hydrogen(molecule);
    if (molecule.size() > carbons && potential.unbonded_reach() > 0) part_hydrogens(molecule);
  }
  const bool strained = molecule.cell && options.relax_cell != minimisation::CellRelaxation::none;
  minimisation::MinimisationOptions wanted{
      .force_tolerance = (strained ? left_in_cell : 1.0) * options.force_tolerance,
      .team = options.running.team};
  PressedWatch pressed(model.rebo2.graph(), options.running.team);
  if (may_give_up && !molecule.cell && level.state.positions.size() >= least_large)
    wanted.stop = [&](int iteration, std::span<const Vec3> x) { return pressed.for_good(iteration, x); };
  const minimisation::CellMinimum end =
      minimisation::minimise_in_cell(molecule, potential, options.relax_cell, wanted);
  return {std::move(molecule), end};
}

// Moves atoms to where the carbons, which come first, fit the surface best, of the size that fits them. Returns by
// how much it grows.
double move_to_surface(std::vector<Vec3>& positions, std::size_t carbons, TriangleMesh surface,
                       const Mat3& deformation, bool keep_size, ThreadTeam* team) {
  if (surface.space.periodic()) mesh::deform(surface, deformation);
  const annealing::Similarity fit =
      annealing::fit_to_surface(std::span<const Vec3>(positions.data(), carbons),
                                annealing::TetherSurface(surface, 1), !keep_size, team);
  for (Vec3& p : positions) p = fit(p) / fit.scale;
  return 1 / fit.scale;
}

// Carbon atoms where REBO2 sees other bonds than the molecule's.
std::vector<AtomIndex> unlike_bonds(const Molecule& molecule) {
  const Molecule carbon = molecule::carbon_skeleton(molecule);
  return annealing::tangled_atoms(carbon.positions, annealing::fixed_bond_graph(carbon));
}

}  // namespace

FinalMinimum final_minimum(annealing::AnnealingLevel level, const TriangleMesh& surface, std::size_t atoms,
                           potential::Potential& potential, const AnnealOptions& options) {
  if (options.progress) options.progress("minimising", 0);
  level.state.network.hydrogen = options.hydrogen;
  const bool alike = potential.unbonded_reach() == 0 && level.state.positions.size() >= least_large;
  Descent descent =
      descend(level, surface, alike ? left_of_large : left_on_fixed_bonds, true, potential, options);
  for (int mending = 0; mending < mendings && !descent.end.minimum.intact; ++mending) {
    level.sound = false;
    annealing::mend_level(level, annealing::TetherSurface(surface, 1), schedule_for(atoms, options),
                          unlike_bonds(descent.molecule));
    descent = descend(level, surface, alike ? left_of_large : left_once_mended, mending + 1 < mendings,
                      potential, options);
  }
  const minimisation::MinimisationResult& minimum = descent.end.minimum;
  FinalMinimum result;
  result.molecule = std::move(descent.molecule);
  result.network = std::move(level.state.network);
  result.deformation = descent.end.deformation;
  result.stress = descent.end.stress;
  result.accepted = level.accepted;
  result.rest = resting_state(result.molecule, potential, minimum.energy, minimum.max_force, minimum.intact);
  const auto timed = options.running.stage("fitting");
  for (Vec3& p : level.state.positions) p = result.deformation * p;
  annealing::bring_back(result.molecule.positions, level.state.positions, !result.molecule.cell);
  result.growth = move_to_surface(result.molecule.positions, result.network.atoms.size(), surface,
                                  result.deformation, options.keep_size, options.running.team);
  return result;
}

RestingState resting_state(const Molecule& molecule, const potential::Potential& potential, double energy,
                           double max_force, bool intact) {
  const Molecule carbon = molecule::carbon_skeleton(molecule);
  const annealing::GeometryCheck check =
      annealing::check_geometry(carbon.positions, annealing::fixed_bond_graph(carbon));
  const std::size_t carbons = carbon.size(), hydrogens = molecule.size() - carbons;
  return {
      .energy = energy / static_cast<double>(molecule.size()),
      .above_graphene = potential.above_graphene(energy, carbons, hydrogens) / static_cast<double>(carbons),
      .max_force = max_force,
      .intact = intact,
      .closest_unbonded = check.closest_unbonded};
}

}  // namespace nanocarbon::building
