// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/annealing_level.h"

#include <algorithm>

#include "nanocarbon/annealing/dual_relaxation.h"
#include "nanocarbon/annealing/geometry_check.h"
#include "nanocarbon/annealing/unknot.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/nearest_point.h"

namespace nanocarbon::annealing {

namespace {

// Whole bonds end at 1.7 Angstrom for REBO2, and other atoms are seen from 2.0.
constexpr double safe_bond = 1.66, safe_distance = 2.05;

// With fewer atoms defects everywhere are tried: that takes a fifth of a millisecond for each atom, and on the way rids
// drafts of defects (7 to 14 meV an atom at 2,000 atoms).
constexpr std::size_t least_large = 20000;

bool is_safe(double longest_bond, double closest_unbonded) {
  return longest_bond < safe_bond && closest_unbonded > safe_distance;
}

}  // namespace

namespace {

// Atoms with one neighbour or none; what their removal leaves so is removed as well.
std::vector<AtomIndex> dead_ends(const TrivalentNetwork& network) {
  std::vector<unsigned> degree;
  std::vector<AtomIndex> ends;
  for (const TrivalentAtom& atom : network.atoms)
    degree.push_back(static_cast<unsigned>(std::count_if(atom.neighbour.begin(), atom.neighbour.end(),
                                                         [](AtomIndex n) { return n != no_atom; })));
  for (AtomIndex a = 0; a < degree.size(); ++a)
    if (degree[a] < 2) ends.push_back(a);
  for (std::size_t k = 0; k < ends.size(); ++k)
    for (const AtomIndex n : network.atoms[ends[k]].neighbour)
      if (n != no_atom && --degree[n] == 1) ends.push_back(n);
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

TriangleMesh without(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles) {
  TriangleMesh kept;
  kept.space = mesh.space;
  std::vector<VertexIndex> renumbered(mesh.points.size(), no_atom);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (std::binary_search(triangles.begin(), triangles.end(), t)) continue;
    Triangle corners = mesh.triangles[t];
    for (VertexIndex& v : corners) {
      if (renumbered[v] == no_atom) {
        renumbered[v] = static_cast<VertexIndex>(kept.points.size());
        kept.points.push_back(mesh.points[v]);
      }
      v = renumbered[v];
    }
    kept.triangles.push_back(corners);
  }
  return kept;
}

}  // namespace

std::optional<AnnealingLevel> level_on(const TriangleMesh& triangulation, const LevelOptions& options) {
  const auto stage = options.running.stage("dual");
  AnnealingLevel level;
  level.state.running = options.running;
  try {
    level.state.network = trivalent_network(triangulation);
    const std::vector<AtomIndex> ends = dead_ends(level.state.network);
    if (!ends.empty()) return level_on(without(triangulation, ends), options);
  } catch (const UserError&) {
    return {};
  }
  level.state.network.hydrogen = true;
  level.state.network.steric_reach = options.steric_reach;
  level.state.space = triangulation.space;
  for (const Triangle& t : triangulation.triangles) {
    const auto [a, b, c] = corners_of(triangulation, t);
    level.state.positions.push_back((a + b + c) / 3);
  }
  level.state.tether = options.tether;
  level.state.free_mean = options.free_mean;
  return level;
}

bool holds(const AnnealingLevel& level) {
  const GeometryCheck check =
      check_geometry(level.state.positions, fixed_bond_graph(level.state.network, level.state.space));
  return is_safe(check.longest_bond, check.closest_unbonded);
}

void relax_level(AnnealingLevel& level, const TetherSurface& surface, bool raw) {
  const auto relaxed =
      relax_network(fixed_bond_graph(level.state.network, level.state.space), level.state.positions, surface,
                    {.tether = level.state.tether,
                     .unknotting_attempts = raw ? 1u : 0u,
                     .free_mean = level.state.free_mean,
                     .springs_first = raw,
                     .running = level.state.running});
  level.unannealed = relaxed.energy / static_cast<double>(level.state.positions.size());
  level.mean_distance = relaxed.mean_distance;
  level.sound = is_safe(relaxed.longest_bond, relaxed.closest_unbonded);
}

void anneal_level(AnnealingLevel& level, const TetherSurface& surface, BondSwitchingOptions options) {
  options.tether = level.state.tether;
  level.accepted += anneal_bonds(level.state, surface, options).accepted;
}

void mend_level(AnnealingLevel& level, const TetherSurface& surface, BondSwitchingOptions options,
                std::span<const AtomIndex> places) {
  options.hot = options.cold = 0.2;
  options.blocks = 1;
  options.trials_per_defect = 5;
  if (level.state.positions.size() >= least_large && !places.empty()) {
    options.around.assign(places.begin(), places.end());
    options.trials_per_defect = 20;
  }
  options.tether = level.state.tether;
  for (int round = 0; round < 4 && !level.sound; ++round) {
    options.seed += 100;
    level.accepted += anneal_bonds(level.state, surface, options).accepted;
    relax_level(level, surface, false);
    // Atoms may have got other numbers.
    if (!options.around.empty() && !level.sound)
      options.around =
          tangled_atoms(level.state.positions, fixed_bond_graph(level.state.network, level.state.space),
                        level.state.running.team, {safe_bond, safe_distance});
  }
}

double lost_reach(const AnnealingLevel& level, const TriangleMesh& surface) {
  const TriangleMesh triangulation =
      triangulation_of(level.state.network, level.state.positions, level.state.space);
  const mesh::NearestPoint nearest(triangulation);
  double lost = 0;
  for (const mesh::SurfacePoint& foot : nearest.nearest(surface.points)) lost = std::max(lost, foot.distance);
  return lost;
}

}  // namespace nanocarbon::annealing
