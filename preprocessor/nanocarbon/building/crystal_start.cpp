// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/crystal_start.h"

#include <fmt/format.h>

#include "nanocarbon/building/stopwatch.h"
#include "nanocarbon/core/error.h"

namespace nanocarbon::building {

CrystalStart crystal_start(const TriangleMesh& surface, std::size_t atoms, const AnnealOptions& options,
                           int attempts) {
  Stopwatch watch;
  const auto timed = options.running.stage("crystallising");
  const crystal::CrystalResult made = crystal::crystallise(surface, {.faces = atoms,
                                                                     .seed = options.seed,
                                                                     .quality = options.quality,
                                                                     .attempts = attempts,
                                                                     .team = options.running.team,
                                                                     .progress = options.progress});
  const double seconds = watch.lap();
  return {annealing::level_on(made.mesh, level_options(options)), seconds};
}

CrystalStart full_size_start(const TriangleMesh& surface, std::size_t atoms, const AnnealOptions& options) {
  constexpr std::uint64_t seeds = 4;
  AnnealOptions with_seed = options;
  double seconds = 0;
  for (std::uint64_t k = 0; k < seeds; ++k) {
    with_seed.seed = options.seed + k;
    CrystalStart start = crystal_start(surface, atoms, with_seed);
    start.seconds += seconds;
    if (start.level) return start;
    seconds = start.seconds;
  }
  throw UserError(Failure::size,
                  fmt::format("{} atoms are too few for the thinnest parts of the surface: its "
                              "triangulation pinches them",
                              atoms));
}

}  // namespace nanocarbon::building
