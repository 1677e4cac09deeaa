// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/coarse_starts.h"

#include <utility>

#include "nanocarbon/building/annealing_schedules.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/potential/rebo2/parameters.h"

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

}  // namespace

CoarseStarts::CoarseStarts(const TriangleMesh& surface, std::size_t atoms, int refinements,
                           Triangulator triangulate, AnnealOptions options)
    : surface_(surface),
      atoms_(atoms >> (2 * refinements)),
      refinements_(refinements),
      triangulate_(std::move(triangulate)),
      options_(std::move(options)),
      attempts_(options_.quality == Quality::best ? 4 : 2) {
  rescale(surface_, scale());
}

std::optional<annealing::AnnealingLevel> CoarseStarts::next() {
  std::optional<annealing::AnnealingLevel> level = annealed();
  if (!level && annealed_ < attempts_ && make_room()) level = annealed();
  ++attempt_;
  return level;
}

// Whether there is more room now. Once is enough for all starts that follow.
bool CoarseStarts::make_room() {
  if (roomy_ || !options_.make_room) return false;
  roomy_ = true;
  std::optional<TriangleMesh> roomy = options_.make_room(surface_);
  if (!roomy) return false;
  surface_ = *std::move(roomy);
  lost_for_good_ = false;
  return true;
}

std::optional<annealing::AnnealingLevel> CoarseStarts::triangulated() const {
  try {
    return annealing::level_on(
        triangulate_(surface_, atoms_, options_.seed + static_cast<std::uint64_t>(attempt_)),
        options_.tether * std::pow(coarse_tether, refinements_), !options_.keep_size);
  } catch (const UserError&) {  // too few atoms for the surface's topology
    return {};
  }
}

bool CoarseStarts::too_bent(const annealing::AnnealingLevel& level) const {
  return refinements_ > 1 && options_.quality != Quality::best &&
         level.unannealed > rebo2::graphene_energy + most_bent;
}

std::optional<annealing::AnnealingLevel> CoarseStarts::annealed() {
  std::optional<annealing::AnnealingLevel> level = triangulated();
  if (!level) return {};
  const annealing::TetherSurface tether_surface(surface_, 1);
  annealing::relax_level(*level, tether_surface);
  const bool near = level->mean_distance < coarse_distance * scale();
  if (!near || too_bent(*level) || !(annealing::lost_reach(*level, surface_) < lost_at_start * scale()))
    return {};
  annealing::BondSwitchingOptions hot = hot_schedule(atoms_, true, options_);
  hot.seed += 1000 * static_cast<std::uint64_t>(attempt_);
  hot.progress = [&](int block, double, std::size_t, std::size_t) {
    if (options_.progress)
      options_.progress("annealing coarsely", (annealed_ + (block + 1.0) / hot.blocks) / attempts_);
  };
  annealing::anneal_level(*level, tether_surface, hot);
  ++annealed_;
  const double lost = annealing::lost_reach(*level, surface_);
  lost_for_good_ = lost > lost_for_good * scale();
  if (!(lost < lost_in_the_end * scale()) || !annealing::holds(*level)) return {};
  return level;
}

}  // namespace nanocarbon::building
