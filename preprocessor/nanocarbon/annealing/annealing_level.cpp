// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/annealing_level.h"

#include <algorithm>

#include "nanocarbon/annealing/dual_relaxation.h"
#include "nanocarbon/annealing/geometry_check.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/nearest_point.h"

namespace nanocarbon::annealing {

namespace {

// Whole bonds end at 1.7 Angstrom for REBO2, and other atoms are seen from 2.0.
constexpr double safe_bond = 1.66, safe_distance = 2.05;

bool is_safe(double longest_bond, double closest_unbonded) {
  return longest_bond < safe_bond && closest_unbonded > safe_distance;
}

}  // namespace

std::optional<AnnealingLevel> level_on(const TriangleMesh& triangulation, double tether, bool free_mean) {
  AnnealingLevel level;
  try {
    level.state.network = trivalent_network(triangulation);
  } catch (const UserError&) {
    return {};
  }
  level.state.space = triangulation.space;
  for (const Triangle& t : triangulation.triangles) {
    const auto [a, b, c] = corners_of(triangulation, t);
    level.state.positions.push_back((a + b + c) / 3);
  }
  level.state.tether = tether;
  level.state.free_mean = free_mean;
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
                     .untangling_attempts = raw ? 1u : 0u,
                     .free_mean = level.state.free_mean,
                     .springs_first = raw});
  level.unannealed = relaxed.energy / static_cast<double>(level.state.positions.size());
  level.mean_distance = relaxed.mean_distance;
  level.sound = is_safe(relaxed.longest_bond, relaxed.closest_unbonded);
}

void anneal_level(AnnealingLevel& level, const TetherSurface& surface, BondSwitchingOptions options) {
  options.tether = level.state.tether;
  level.accepted += anneal_bonds(level.state, surface, options).accepted;
}

void mend_level(AnnealingLevel& level, const TetherSurface& surface, BondSwitchingOptions options) {
  options.hot = options.cold = 0.2;
  options.blocks = 1;
  options.trials_per_defect = 5;
  options.tether = level.state.tether;
  for (int round = 0; round < 4 && !level.sound; ++round) {
    options.seed += 100;
    level.accepted += anneal_bonds(level.state, surface, options).accepted;
    relax_level(level, surface, false);
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
