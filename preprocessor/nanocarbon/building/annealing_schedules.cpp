// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/annealing_schedules.h"

#include <algorithm>

namespace nanocarbon::building {

namespace {

constexpr std::size_t coarsest = 225;  // atoms: fewer cannot show a shape, and cost more for each

// Atoms up to which a hot start at full size is affordable where no coarser one is useful: a long one where
// none was tried. Below the other number a short one must do everywhere.
constexpr std::size_t small = 1800, tiny = 400;

}  // namespace

int refinements_for(std::size_t atoms, Quality quality) {
  if (quality == Quality::draft) return 0;
  int levels = 0;
  while (levels < 2 && (atoms >> (2 * (levels + 1))) >= coarsest) ++levels;
  return levels;
}

annealing::BondSwitchingOptions schedule_for(std::size_t atoms, const AnnealOptions& options) {
  annealing::BondSwitchingOptions schedule;
  schedule.target_atoms = atoms;
  schedule.seed = options.seed;
  schedule.threads = options.running.threads();
  schedule.largest_ring = options.largest_ring;
  schedule.cold = 0.2;
  return schedule;
}

annealing::BondSwitchingOptions hot_schedule(std::size_t atoms, bool at_length,
                                             const AnnealOptions& options) {
  annealing::BondSwitchingOptions hot = schedule_for(atoms, options);
  at_length = at_length && atoms >= tiny;
  hot.hot = at_length ? 0.6 : 0.5;
  hot.blocks = at_length ? 36 : 24;
  return hot;
}

// Cooling from where defects just begin to move freely: a crystal's order over long ranges survives it. Small
// molecules have none to lose.
annealing::BondSwitchingOptions full_size_schedule(std::size_t atoms, bool alone,
                                                   const AnnealOptions& options) {
  annealing::BondSwitchingOptions single = schedule_for(atoms, options);
  single.hot = 0.35;
  single.blocks = 12;
  if (alone && atoms < small)
    single = hot_schedule(atoms, refinements_for(atoms, options.quality) == 0, options);
  if (options.quality == Quality::best) single.blocks = 48;
  return single;
}

annealing::BondSwitchingOptions hot_schedule_in_cell(std::size_t atoms, const AnnealOptions& options) {
  annealing::BondSwitchingOptions hot = schedule_for(atoms, options);
  hot.hot = 0.7;
  hot.blocks = options.quality == Quality::best ? 48 : 24;
  hot.trials_per_defect = 50;
  return hot;
}

double refined_tether(double tether) {
  constexpr double share = 0.2;
  return tether - (1 - share) * std::min(tether, default_tether);
}

annealing::BondSwitchingOptions refined_schedule(std::size_t atoms, const AnnealOptions& options) {
  annealing::BondSwitchingOptions refined = schedule_for(atoms, options);
  refined.hot = 0.35;
  refined.blocks = options.quality == Quality::best ? 16 : 8;
  refined.trials_per_defect = 60;
  return refined;
}

}  // namespace nanocarbon::building
