// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/dual_relaxation.h"

#include "nanocarbon/annealing/fixed_bond_model.h"
#include "nanocarbon/annealing/geometry_check.h"
#include "nanocarbon/annealing/spring_relaxation.h"
#include "nanocarbon/annealing/unknot.h"
#include "nanocarbon/core/chunks.h"

namespace nanocarbon::annealing {

namespace {

// Larger molecules are relaxed again only around what was unknotted, if that is not more than this share of them.
constexpr std::size_t least_large = 2000;
constexpr double most_around = 0.1;

void relax_unknotted(FixedBondModel& model, const TetherSurface& surface, std::vector<Vec3>& positions,
                     std::span<const AtomIndex> unknotted, int iterations) {
  const auto atoms = static_cast<double>(positions.size());
  if (positions.size() < least_large || static_cast<double>(unknotted.size()) > most_around * atoms)
    relax_by_springs(model, surface, positions, iterations);
  else
    relax_by_springs_around(model, surface, positions, unknotted, iterations);
}

double mean_distance(const TetherSurface& surface, std::span<const Vec3> positions, ThreadTeam* team) {
  const double sum = sum_chunks(team, positions.size(), [&](std::size_t begin, std::size_t end) {
    double part = 0;
    for (std::size_t a = begin; a < end; ++a) part += surface.distance(positions[a]);
    return part;
  });
  return sum / static_cast<double>(positions.size());
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
  for (unsigned attempt = 0; attempt <= options.unknotting_attempts; ++attempt) {
    const auto stage = model.running.stage("tethered");
    relaxed = minimise_fixed_bonds(
        model, &surface, positions,
        {.max_iterations = options.max_iterations, .force_tolerance = options.force_tolerance});
    const std::vector<AtomIndex> tangled = tangled_atoms(positions, model.rebo2.graph(), model.running.team);
    if (tangled.empty() || attempt == options.unknotting_attempts) break;
    const std::vector<AtomIndex> unknotted =
        unknot(positions, model.rebo2.graph(), surface, tangled, 3 + 2 * attempt);
    result.unknotted = unknotted.size();
    relax_unknotted(model, surface, positions, unknotted, options.max_iterations);
  }

  std::vector<Vec3> gradient(positions.size(), Vec3::Zero());
  result.energy = model.rebo2.evaluate(positions, gradient, model.running.team);
  result.max_force = relaxed.max_force;
  const GeometryCheck check = check_geometry(positions, model.rebo2.graph(), model.running.team);
  result.shortest_bond = check.shortest_bond;
  result.longest_bond = check.longest_bond;
  result.closest_unbonded = check.closest_unbonded;
  result.mean_distance = mean_distance(surface, positions, model.running.team);
  return result;
}

DualRelaxationResult relax_dual(Molecule& molecule, const TetherSurface& surface,
                                const DualRelaxationOptions& options) {
  return relax_network(fixed_bond_graph(molecule), molecule.positions, surface, options);
}

}  // namespace nanocarbon::annealing
