#include "nanocarbon/relaxation/annealing_schedules.h"

namespace nanocarbon {

namespace {

constexpr std::size_t kCoarsest = 225;  // atoms: fewer cannot show a shape, and cost more for each

// Atoms up to which a hot start at full size is affordable where no coarser one is of use: a long one where
// none was tried. Below the other number a short one must do everywhere.
constexpr std::size_t kSmall = 1800, kTiny = 400;

}  // namespace

int refinements_for(std::size_t atoms, AnnealQuality quality) {
  if (quality == AnnealQuality::draft) return 0;
  int levels = 0;
  while (levels < 2 && (atoms >> (2 * (levels + 1))) >= kCoarsest) ++levels;
  return levels;
}

BondSwitchingOptions schedule_for(std::size_t atoms, const AnnealOptions& options) {
  BondSwitchingOptions schedule;
  schedule.target_atoms = atoms;
  schedule.seed = options.seed;
  schedule.threads = options.threads;
  schedule.cold = 0.2;
  return schedule;
}

BondSwitchingOptions hot_schedule(std::size_t atoms, bool at_length, const AnnealOptions& options) {
  BondSwitchingOptions hot = schedule_for(atoms, options);
  at_length = at_length && atoms >= kTiny;
  hot.hot = at_length ? 0.6 : 0.5;
  hot.blocks = at_length ? 36 : 24;
  return hot;
}

// Cooling from where defects just begin to move freely: a crystal's order over long ranges survives it. Small
// molecules have none to lose.
BondSwitchingOptions full_size_schedule(std::size_t atoms, bool alone, const AnnealOptions& options) {
  BondSwitchingOptions single = schedule_for(atoms, options);
  single.hot = 0.35;
  single.blocks = 12;
  if (alone && atoms < kSmall)
    single = hot_schedule(atoms, refinements_for(atoms, options.quality) == 0, options);
  if (options.quality == AnnealQuality::best) single.blocks = 48;
  return single;
}

BondSwitchingOptions refined_schedule(std::size_t atoms, const AnnealOptions& options) {
  BondSwitchingOptions refined = schedule_for(atoms, options);
  refined.hot = 0.35;
  refined.blocks = options.quality == AnnealQuality::best ? 16 : 8;
  refined.trials_per_defect = 60;
  return refined;
}

}  // namespace nanocarbon
