// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/anneal_recipe.h"

#include <utility>

#include "nanocarbon/building/annealed_starts.h"
#include "nanocarbon/building/crystal_start.h"
#include "nanocarbon/remeshing/features/make_room.h"

namespace nanocarbon::building {

AnnealResult anneal(const TriangleMesh& given, std::size_t atoms, potential::Potential& potential,
                    const AnnealOptions& options) {
  const TriangleMesh surface =
      features::with_room_for_sheets(given, features::resting_sheet_distance, options.threads)
          .value_or(given);
  CrystalStart start = full_size_start(surface, atoms, options);
  annealing::relax_level(*start.level, annealing::TetherSurface(surface, 1));
  const double unannealed = start.level->unannealed;
  BestStart best;
  if (options.quality == Quality::draft)
    best.start.level = *std::move(start.level);
  else
    best = best_start(*std::move(start.level), surface, atoms, options);
  AnnealResult result;
  result.minimum = final_minimum(std::move(best.start.level), surface, atoms, potential, options);
  result.record = {.unannealed_energy = unannealed,
                   .refinements = best.start.refinements,
                   .accepted = result.minimum.accepted,
                   .deformation = result.minimum.deformation,
                   .stress = result.minimum.stress};
  result.remeshing_seconds = start.seconds + best.seconds;
  return result;
}

}  // namespace nanocarbon::building
