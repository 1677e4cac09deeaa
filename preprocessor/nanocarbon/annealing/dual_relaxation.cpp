// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/dual_relaxation.h"

#include <algorithm>

#include "nanocarbon/annealing/fixed_bond_model.h"
#include "nanocarbon/annealing/geometry_check.h"
#include "nanocarbon/annealing/network_springs.h"
#include "nanocarbon/annealing/untangle.h"

namespace nanocarbon::annealing {

namespace {

// Holds the shape while springs pull on badly scaled bonds.
constexpr double spring_tether = 0.5;

void relax_by_springs(FixedBondModel& model, const TetherSurface& surface, std::vector<Vec3>& positions,
                      int iterations) {
  const auto stage = model.running.stage("springs");
  for (int round = 0; round < 3; ++round) {
    ThreadTeam* const team = model.running.team;
    model.planes = tangent_planes(surface, positions, model.planes, team);
    const auto energy = [&](std::span<const Vec3> x, std::span<Vec3> g) {
      const FixedBondGraph& graph = model.rebo2.graph();
      return add_springs(graph, model.rebo2.chunks(), x, g, team) +
             model.contacts.evaluate(x, graph, g, team) +
             add_tether(model.planes, spring_tether, x, g, model.free_mean, team);
    };
    minimisation::minimise_lbfgs(positions, energy,
                                 {.max_iterations = iterations / 3, .force_tolerance = 0.05, .team = team});
  }
}

}  // namespace

DualRelaxationResult relax_network(const FixedBondGraph& graph, std::vector<Vec3>& positions,
                                   const TetherSurface& surface, const DualRelaxationOptions& options) {
  FixedBondModel model;
  model.rebo2.set_graph(graph);
  model.tether = options.tether;
  model.free_mean = options.free_mean;
  model.running = options.running;
  if (options.springs_first) relax_by_springs(model, surface, positions, options.max_iterations);
  DualRelaxationResult result;
  minimisation::LbfgsResult relaxed;
  for (unsigned attempt = 0; attempt <= options.untangling_attempts; ++attempt) {
    const auto stage = model.running.stage("tethered");
    relaxed = minimise_fixed_bonds(
        model, &surface, positions,
        {.max_iterations = options.max_iterations, .force_tolerance = options.force_tolerance});
    const std::vector<AtomIndex> tangled = tangled_atoms(positions, model.rebo2.graph());
    if (tangled.empty() || attempt == options.untangling_attempts) break;
    result.untangled = untangle(positions, model.rebo2.graph(), surface, tangled, 3 + 2 * attempt);
    relax_by_springs(model, surface, positions, options.max_iterations);
  }

  std::vector<Vec3> gradient(positions.size(), Vec3::Zero());
  result.energy = model.rebo2.evaluate(positions, gradient);
  result.max_force = relaxed.max_force;
  const GeometryCheck check = check_geometry(positions, model.rebo2.graph());
  result.shortest_bond = check.shortest_bond;
  result.longest_bond = check.longest_bond;
  result.closest_unbonded = check.closest_unbonded;
  for (const Vec3& p : positions)
    result.mean_distance += surface.distance(p) / static_cast<double>(positions.size());
  return result;
}

DualRelaxationResult relax_dual(Molecule& molecule, const TetherSurface& surface,
                                const DualRelaxationOptions& options) {
  return relax_network(fixed_bond_graph(molecule), molecule.positions, surface, options);
}

}  // namespace nanocarbon::annealing
