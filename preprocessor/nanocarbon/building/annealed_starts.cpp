// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/annealed_starts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "nanocarbon/annealing/refine_network.h"
#include "nanocarbon/building/annealing_schedules.h"
#include "nanocarbon/building/coarse_starts.h"
#include "nanocarbon/building/spring_back.h"
#include "nanocarbon/potential/rebo2/parameters.h"

namespace nanocarbon::building {

namespace {

// Annealing at full size hardly ever leaves less than this of a start's energy above graphene, or of its
// distance to the surface.
constexpr double least_left = 0.75;

// A cell narrower than this has vertices that meet through two images, and levels in it are not tried. Angstrom.
constexpr double least_width = 9;

// With the progress of this stage told.
annealing::BondSwitchingOptions told(annealing::BondSwitchingOptions schedule, std::string_view stage,
                                     const AnnealOptions& options) {
  schedule.progress = [&options, stage](double share) {
    if (options.progress) options.progress(stage, share);
  };
  return schedule;
}

AnnealedStart released(annealing::AnnealingLevel level, int refinements, const TriangleMesh& surface,
                       const AnnealOptions& options) {
  const Released after = spring_back(level.state, annealing::TetherSurface(surface, 1), !options.keep_size);
  return {std::move(level), after, refinements};
}

// The levels of refinement that are tried, at most.
int most_refinements(const TriangleMesh& surface, std::size_t atoms, Quality quality) {
  int most = refinements_for(atoms, quality);
  while (most > 0 && std::ldexp(surface.space.least_width(), -most) < least_width) --most;
  return most;
}

// Whether a start at full size could come out better than what there is.
bool may_become_better(const annealing::AnnealingLevel& direct, const AnnealedStart& best,
                       const TriangleMesh& surface, const AnnealOptions& options) {
  Released least = spring_back(direct.state, annealing::TetherSurface(surface, 1), !options.keep_size);
  least.energy = rebo2::graphene_energy + least_left * (least.energy - rebo2::graphene_energy);
  least.mean_distance *= least_left;
  least.left_out *= least_left;
  return is_better(least, best.released, options.tether);
}

}  // namespace

std::optional<AnnealedStart> refined_start(annealing::AnnealingLevel level, int refinements,
                                           const TriangleMesh& surface, std::size_t atoms, double unannealed,
                                           const AnnealOptions& options) {
  for (int left = refinements - 1; left >= 0; --left) {
    const annealing::TetherSurface tether_surface(surface, std::ldexp(1.0, -left));
    level.state = annealing::refined_in_four(level.state, tether_surface);
    level.state.tether = refined_tether(options.tether);
    annealing::relax_level(level, tether_surface);
    if (left == 0 && level.unannealed > unannealed) return {};
    annealing::anneal_level(
        level, tether_surface,
        told(refined_schedule(atoms >> (2 * left), options), "annealing refined", options));
    // An overstretched bond is mostly mended by annealing; where not, without refining.
    if (!annealing::holds(level)) return {};
  }
  return released(std::move(level), refinements, surface, options);
}

AnnealedStart annealed_at_full_size(annealing::AnnealingLevel level, const TriangleMesh& surface,
                                    std::size_t atoms, bool alone, const AnnealOptions& options) {
  annealing::anneal_level(level, annealing::TetherSurface(surface, 1),
                          told(full_size_schedule(atoms, alone, options), "annealing", options));
  return released(std::move(level), 0, surface, options);
}

BestStart best_start(annealing::AnnealingLevel direct, const TriangleMesh& surface, std::size_t atoms,
                     const AnnealOptions& options) {
  const auto better = [&](const AnnealedStart& one, const AnnealedStart& other) {
    return is_better(one.released, other.released, options.tether);
  };
  std::optional<AnnealedStart> best;
  double seconds = 0;
  for (int refinements = most_refinements(surface, atoms, options.quality); refinements > 0; --refinements) {
    CoarseStarts coarse = coarse_starts(surface, atoms, refinements, options);
    seconds += coarse.seconds;
    for (annealing::AnnealingLevel& level : coarse.levels) {
      auto refined = refined_start(std::move(level), refinements, surface, atoms, direct.unannealed, options);
      if (refined && (!best || better(*refined, *best))) best = std::move(refined);
    }
    if (best && is_near(best->released, options.tether)) break;
  }
  if (best && !may_become_better(direct, *best, surface, options)) return {*std::move(best), seconds};
  AnnealedStart whole = annealed_at_full_size(std::move(direct), surface, atoms, !best, options);
  if (best && (!annealing::holds(whole.level) || !better(whole, *best))) return {*std::move(best), seconds};
  return {std::move(whole), seconds};
}

}  // namespace nanocarbon::building
