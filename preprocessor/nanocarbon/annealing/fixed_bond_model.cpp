// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/fixed_bond_model.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "nanocarbon/annealing/local_relaxation.h"
#include "nanocarbon/minimisation/multilevel/sheet_preconditioner.h"

namespace nanocarbon::annealing {

namespace {

// A preconditioner costs about as much as so many iterations to set up: not worth it for a short relaxation.
constexpr int least_iterations = 50;

// From so many atoms on the last places to come to rest are relaxed on their own, between so many iterations of all.
constexpr std::size_t least_large = 20000;
constexpr int between_places = 40;

// One for each atom. Those at the boundary are held across the surface: nothing else holds a flat sheet in its plane,
// where without it the preconditioner would move it far away.
multilevel::Holds holds_of(const FixedBondModel& model) {
  multilevel::Holds holds;
  for (AtomIndex a = 0; a < model.planes.size(); ++a) {
    const bool at_boundary =
        a < model.edges.size() && model.rebo2.graph().open(a) && !model.edges[a].normal.isZero(0.0);
    holds.push_back(at_boundary ? std::sqrt(boundary_tether) * model.edges[a].normal
                                : std::sqrt(model.tether) * model.planes[a].normal);
  }
  return holds;
}

// How much farther or less far the boundary may reach in the mean where the surface's size follows the molecule, Angstrom.
// Without a limit a bowl opens out to a shallow one, of a larger sphere of which it lacks the rim.
constexpr double free_reach = 0.5;

void hold_boundary(FixedBondModel& model, const TetherSurface& surface, std::span<const Vec3> positions) {
  const FixedBondGraph& graph = model.rebo2.graph();
  if (surface.boundary().empty() || !graph.hydrogen) return;
  model.edges = boundary_planes(surface.boundary(), graph, positions);
  model.reach = -open_atom_depth;
  if (model.free_mean)
    model.reach = std::clamp(mean_reach(model.edges, graph, positions), model.reach - free_reach,
                             model.reach + free_reach);
}

// Atoms with a force of at least so much; ascending.
std::vector<AtomIndex> forced_atoms(FixedBondModel& model, std::span<const Vec3> positions, double force) {
  std::vector<Vec3> gradient(positions.size(), Vec3::Zero());
  model.evaluate(positions, gradient);
  std::vector<AtomIndex> forced;
  for (AtomIndex a = 0; a < positions.size(); ++a)
    if (!(gradient[a].squaredNorm() < force * force)) forced.push_back(a);
  return forced;
}

// Relaxes the places where forces are left on their own, and what that leaves around them.
void relax_places(FixedBondModel& model, std::vector<Vec3>& positions, double force_tolerance) {
  constexpr int rounds = 4;
  ThreadTeam* const team = model.running.team;
  std::vector<AtomIndex> forced = forced_atoms(model, positions, force_tolerance);
  for (int round = 0; round < rounds && !forced.empty(); ++round) {
    const bool free_mean = model.free_mean && !model.planes.empty();
    const LocalRelaxation done =
        relax_around({.graph = model.rebo2.graph(),
                      .contacts = model.contacts,
                      .planes = model.planes,
                      .tether = model.tether,
                      .mean_height = free_mean ? mean_height(model.planes, positions, team) : 0,
                      .edges = model.edges,
                      .reach = model.reach},
                     positions, forced, 0.5 * force_tolerance, team);
    if (done.pieces == 0) break;
    std::vector<AtomIndex> left = forced_atoms(model, positions, force_tolerance);
    if (left.size() >= forced.size()) break;
    forced = std::move(left);
  }
}

}  // namespace

double FixedBondModel::evaluate(std::span<const Vec3> positions, std::span<Vec3> gradient) {
  double energy = rebo2.evaluate_guarded(positions, gradient, running.team);
  energy += contacts.evaluate(positions, rebo2.graph(), gradient, running.team);
  if (!planes.empty()) energy += add_tether(planes, tether, positions, gradient, free_mean, running.team);
  energy += add_boundary_tether(edges, rebo2.graph(), reach, positions, gradient);
  return energy;
}

minimisation::LbfgsResult minimise_fixed_bonds(FixedBondModel& model, const TetherSurface* surface,
                                               std::vector<Vec3>& positions,
                                               const minimisation::LbfgsOptions& options, int renewal) {
  const auto energy = [&](std::span<const Vec3> x, std::span<Vec3> g) { return model.evaluate(x, g); };
  std::optional<multilevel::SheetPreconditioner> preconditioner;
  if (positions.size() >= multilevel::least_atoms && options.max_iterations >= least_iterations)
    preconditioner.emplace(model.rebo2.graph().space, positions, bonded_atoms(model.rebo2.graph()),
                           model.running.team);
  const bool in_places =
      preconditioner && positions.size() >= least_large && !model.rebo2.graph().space.periodic();
  minimisation::LbfgsResult result;
  int iterations = 0;
  do {
    if (surface) {
      model.planes = tangent_planes(*surface, positions, model.planes, model.running.team);
      hold_boundary(model, *surface, positions);
    }
    if (in_places) relax_places(model, positions, options.force_tolerance);
    // The normals change little on the way.
    if (preconditioner && iterations == 0) preconditioner->renew(positions, holds_of(model));
    minimisation::LbfgsOptions part = options;
    part.max_iterations = options.max_iterations - iterations;
    part.team = model.running.team;
    part.preconditioner = preconditioner ? &*preconditioner : nullptr;
    if (surface) part.max_iterations = std::min(part.max_iterations, renewal);
    if (in_places) part.max_iterations = std::min(part.max_iterations, between_places);
    result = minimisation::minimise_lbfgs(positions, energy, part);
    iterations += std::max(result.iterations, 1);
    // Planes renewed after convergence would move the minimum by a little: the caller's tolerance has been
    // met.
  } while (!result.converged && iterations < options.max_iterations);
  result.iterations = iterations;
  return result;
}

}  // namespace nanocarbon::annealing
