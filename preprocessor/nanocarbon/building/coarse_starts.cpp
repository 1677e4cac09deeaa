// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/coarse_starts.h"

#include <cmath>
#include <utility>

#include "nanocarbon/building/annealing_schedules.h"
#include "nanocarbon/building/crystal_start.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/potential/rebo2/parameters.h"
#include "nanocarbon/remeshing/features/make_room.h"

namespace nanocarbon::building {

namespace {

// Stiffer than the tether that was asked for by this for each refinement.
constexpr double coarse_tether = 3;

// Atoms farther from the surface than this in the mean, multiplied up to the full size, have lost the shape,
// and so have those beyond which the surface reaches farther than this, at the start and once annealed,
// Angstrom at full size.
constexpr double coarse_distance = 3, lost_at_start = 8, lost_in_the_end = 10;
// Where so much is lost the next start will lose too much as well.
constexpr double lost_for_good = 12;

// At a sixteenth of the atoms, a start with more energy than this above graphene, eV an atom, is not annealed
// but for the best quality: bent (or open) so much, annealing takes long and hardly ever leaves something
// that holds and shows the shape. C60 has 0.55, C240 0.20.
constexpr double most_bent = 0.35;

bool too_bent(const annealing::AnnealingLevel& level, int refinements, Quality quality) {
  return refinements > 1 && quality != Quality::best && level.unannealed > rebo2::graphene_energy + most_bent;
}

double scale_of(int refinements) { return std::ldexp(1.0, -refinements); }

// The level has its own seed and a stiffer tether. Nothing where there are too few atoms for the topology.
CrystalStart coarse_crystal(const TriangleMesh& surface, std::size_t atoms, int refinements, int attempt,
                            AnnealOptions options) {
  options.seed += static_cast<std::uint64_t>(attempt);
  options.tether *= std::pow(coarse_tether, refinements);
  // Only smooth shapes are annealed at a sixteenth of the atoms, and there the first seed is enough.
  const int attempts = refinements > 1 ? 1 : crystal::CrystalOptions{}.attempts;
  try {
    return crystal_start(surface, atoms, options, attempts);
  } catch (const UserError&) {
    return {};
  }
}

}  // namespace

CoarseStart anneal_coarse_start(annealing::AnnealingLevel level, const TriangleMesh& surface,
                                std::size_t atoms, int refinements, const AnnealOptions& options,
                                std::uint64_t seed) {
  const double scale = scale_of(refinements);
  const annealing::TetherSurface tether_surface(surface, 1);
  annealing::relax_level(level, tether_surface);
  const bool near = level.mean_distance < coarse_distance * scale;
  if (!near || too_bent(level, refinements, options.quality) ||
      !(annealing::lost_reach(level, surface) < lost_at_start * scale))
    return {};
  annealing::BondSwitchingOptions hot = hot_schedule(atoms, true, options);
  hot.seed = seed;
  hot.progress = [&](double share) {
    if (options.progress) options.progress("annealing coarsely", share);
  };
  annealing::anneal_level(level, tether_surface, hot);
  CoarseStart start;
  start.annealed = true;
  const double lost = annealing::lost_reach(level, surface);
  start.hopeless = lost > lost_for_good * scale;
  if (lost < lost_in_the_end * scale && annealing::holds(level)) start.level = std::move(level);
  return start;
}

CoarseStarts coarse_starts(const TriangleMesh& full, std::size_t atoms, int refinements,
                           const AnnealOptions& options) {
  const int most = options.quality == Quality::best ? 4 : 2;
  const std::size_t coarse_atoms = atoms >> (2 * refinements);
  TriangleMesh surface = full;
  rescale(surface, scale_of(refinements));
  CoarseStarts starts;
  AnnealOptions told = options;
  if (options.progress)
    told.progress = [&](std::string_view stage, double share) {
      options.progress(stage, (starts.annealed + share) / most);
    };
  const auto next = [&]() -> CoarseStart {
    CrystalStart crystal = coarse_crystal(surface, coarse_atoms, refinements, starts.tried, options);
    starts.seconds += crystal.seconds;
    if (!crystal.level) return {};
    const auto attempt = static_cast<std::uint64_t>(starts.tried);
    CoarseStart start = anneal_coarse_start(*std::move(crystal.level), surface, coarse_atoms, refinements,
                                            told, options.seed + 1000 * attempt);
    starts.annealed += start.annealed;
    return start;
  };
  bool room_was_made = false, hopeless = false;
  for (; starts.tried < most && starts.annealed < most && !hopeless; ++starts.tried) {
    CoarseStart start = next();
    if (!start.level && starts.annealed < most && !std::exchange(room_was_made, true))
      if (auto roomy = features::with_room_for_sheets(surface, features::resting_sheet_distance,
                                                      options.running.threads())) {
        surface = *std::move(roomy);
        starts.widened = true;
        start = next();
      }
    hopeless = start.hopeless;
    if (start.level) starts.levels.push_back(*std::move(start.level));
  }
  return starts;
}

}  // namespace nanocarbon::building
