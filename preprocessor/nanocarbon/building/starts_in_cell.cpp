// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/starts_in_cell.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "nanocarbon/annealing/refine_network.h"
#include "nanocarbon/building/annealing_schedules.h"
#include "nanocarbon/building/crystal_start.h"
#include "nanocarbon/building/spring_back.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/periodic_mesh.h"
#include "nanocarbon/remeshing/crystal/hexagonal_tori.h"

namespace nanocarbon::building {

namespace {

// Atoms that are annealed from hot: with fewer a surface hardly shows, with more it takes too long to find the best
// places.
constexpr double fewest_annealed = 130, wanted_annealed = 200;
// Up to so many, full size is annealed from hot, and up to fewer from three starts. So few are annealed hotter and shorter,
// and of them each block is compared once it is let go.
constexpr std::size_t few = 600, very_few = 300;
// Starts with few atoms, of which the best is refined. They are held to the surface more by the first of these for each
// quartering, and those that lie farther from it than the second, Angstrom at full size, are dropped.
constexpr int coarse_starts = 2;
constexpr double coarse_tether = 3, coarse_distance = 3;
// Starts at full size beside them. From so many atoms on these are always in worse order, and there is one more with few
// atoms, which costs little beside what refining does.
constexpr int full_size_starts = 2;
constexpr std::size_t many = 4000;
// Of the atoms wanted: refining multiplies the number that a coarse start has come to, and to meet what is wanted
// exactly takes dislocations, which cost more than they are worth.
constexpr double atoms_off = 0.02;

// A cell narrower than this has vertices that meet through two images. Angstrom.
constexpr double least_width = 9;

struct Step {
  int h, k;
  std::size_t factor() const { return static_cast<std::size_t>(h * h + h * k + k * k); }
};

struct Path {
  std::vector<Step> steps;
  std::size_t factor = 1;
};

// The steps from about 200 atoms up to full size; none where that is fewer than twice as many.
Path path_to(std::size_t atoms, double width) {
  const Path paths[] = {{{{1, 1}}, 3},
                        {{{2, 0}}, 4},
                        {{{2, 1}}, 7},
                        {{{3, 0}}, 9},
                        {{{1, 1}, {2, 0}}, 12},
                        {{{2, 0}, {2, 0}}, 16},
                        {{{1, 1}, {2, 1}}, 21},
                        {{{2, 0}, {2, 1}}, 28},
                        {{{2, 0}, {3, 0}}, 36},
                        {{{2, 0}, {2, 0}, {1, 1}}, 48},
                        {{{2, 0}, {2, 0}, {2, 0}}, 64}};
  Path best;
  double farthest = std::numeric_limits<double>::infinity();
  for (const Path& path : paths) {
    const double coarse = static_cast<double>(atoms) / static_cast<double>(path.factor);
    if (coarse < fewest_annealed || width / std::sqrt(static_cast<double>(path.factor)) < least_width)
      continue;
    const double off = std::abs(std::log(coarse / wanted_annealed));
    if (off >= farthest) continue;
    farthest = off;
    best = path;
  }
  return best;
}

TriangleMesh strained(TriangleMesh surface, const Mat3& strain) {
  if (!strain.isIdentity(0)) mesh::deform(surface, strain);
  return surface;
}

void strain(annealing::SwitchingState& state, const Mat3& by) {
  for (Vec3& p : state.positions) p = by * p;
  state.planes.clear();
  state.space = state.space.strained(by);
}

class Annealing {
 public:
  Annealing(const TriangleMesh& surface, std::size_t atoms, const AnnealOptions& options)
      : surface_(surface), atoms_(atoms), options_(options) {}

  BestStart best(annealing::AnnealingLevel direct) {
    AnnealedStart start = best_of(std::move(direct));
    return {std::move(start), seconds_};
  }

 private:
  AnnealedStart best_of(annealing::AnnealingLevel direct) {
    if (atoms_ > few) {
      const Path path = path_to(atoms_, surface_.space.least_width());
      if (std::optional<AnnealedStart> best = path.steps.empty() ? std::nullopt : best_of_large(direct, path))
        return *std::move(best);
    }
    std::optional<AnnealedStart> best;
    const int starts = atoms_ > very_few ? 1 : 3;
    for (int k = 0; k < starts; ++k) {
      std::optional<annealing::AnnealingLevel> level =
          k == 0 ? std::move(direct)
                 : started(surface_, atoms_, options_.tether, options_.seed + static_cast<std::uint64_t>(k));
      if (!level) continue;
      AnnealedStart candidate = annealed(*std::move(level), k);
      if (!best || (annealing::holds(candidate.level) && is_better(candidate.released, best->released)))
        best = std::move(candidate);
    }
    if (best->deformation.isIdentity(1e-4)) return *std::move(best);
    return annealed_in_its_cell(*std::move(best), refined_schedule(atoms_, options_));
  }

  // The start that is best before it is annealed at full size; nothing where none was refined, or bonds do not hold.
  std::optional<AnnealedStart> best_of_large(const annealing::AnnealingLevel& direct, const Path& path) {
    std::optional<AnnealedStart> best = refined(path);
    if (!best) return {};
    for (int k = 0; k < (atoms_ < many ? full_size_starts : 0); ++k) {
      std::optional<annealing::AnnealingLevel> level =
          k == 0 ? std::optional(direct)
                 : started(surface_, atoms_, options_.tether, options_.seed + static_cast<std::uint64_t>(k));
      if (!level || !annealing::holds(*level)) continue;
      AnnealedStart candidate{.level = *std::move(level)};
      candidate.released = let_go(candidate.level.state, surface_, candidate.deformation);
      if (is_better(candidate.released, best->released)) best = std::move(candidate);
    }
    annealing::BondSwitchingOptions schedule = best->refinements > 0
                                                   ? refined_schedule(atoms_, options_)
                                                   : full_size_schedule(atoms_, false, options_);
    schedule.target_atoms = attainable(best->level, atoms_);
    AnnealedStart annealed = annealed_in_its_cell(*std::move(best), schedule);
    if (!annealing::holds(annealed.level)) return {};
    return annealed;
  }

  // How many atoms a level is to have: as many as it has, if those are about as many as are wanted.
  static std::size_t attainable(const annealing::AnnealingLevel& level, std::size_t wanted) {
    const auto off = static_cast<std::size_t>(atoms_off * static_cast<double>(wanted));
    return std::clamp(level.state.positions.size(), wanted - off, wanted + off);
  }

  Released let_go(const annealing::SwitchingState& state, const TriangleMesh& surface,
                  Mat3& deformation) const {
    return spring_back_in_cell(state, surface, options_.relax_cell, deformation);
  }
  bool is_better(const Released& one, const Released& other) const {
    return building::is_better(one, other, options_.tether);
  }
  annealing::BondSwitchingOptions told(annealing::BondSwitchingOptions schedule,
                                       std::string_view stage) const {
    schedule.progress = [this, stage](double share) {
      if (options_.progress) options_.progress(stage, share);
    };
    return schedule;
  }

  // Blocks of small cells are compared by what they are once they and the cell are let go, not under the tether and
  // strained as they are.
  annealing::BondSwitchingOptions judged(annealing::BondSwitchingOptions schedule,
                                         const TriangleMesh& surface) const {
    if (schedule.target_atoms > very_few) return schedule;
    schedule.judged = [this, &surface](const annealing::SwitchingState& state) {
      Mat3 deformation;
      return cost(let_go(state, surface, deformation), options_.tether) *
             static_cast<double>(state.positions.size());
    };
    return schedule;
  }

  // Relaxed; nothing where thin parts are pinched or the topology asks for more atoms.
  std::optional<annealing::AnnealingLevel> started(const TriangleMesh& surface, std::size_t atoms,
                                                   double tether, std::uint64_t seed) {
    AnnealOptions options = options_;
    options.tether = tether;
    options.seed = seed;
    try {
      CrystalStart start = crystal_start(surface, atoms, options);
      seconds_ += start.seconds;
      if (start.level) annealing::relax_level(*start.level, annealing::TetherSurface(surface, 1));
      return std::move(start.level);
    } catch (const UserError&) {
      return {};
    }
  }

  AnnealedStart annealed(annealing::AnnealingLevel level, int start) const {
    annealing::BondSwitchingOptions schedule =
        judged(atoms_ > very_few ? full_size_schedule(atoms_, true, options_)
                                 : hot_schedule_in_cell(atoms_, options_),
               surface_);
    schedule.seed += 1000 * static_cast<std::uint64_t>(start);
    annealing::anneal_level(level, annealing::TetherSurface(surface_, 1), told(schedule, "annealing"));
    AnnealedStart candidate{.level = std::move(level)};
    candidate.released = let_go(candidate.level.state, surface_, candidate.deformation);
    return candidate;
  }

  // Once more, in the cell as the molecule strains it.
  AnnealedStart annealed_in_its_cell(AnnealedStart candidate,
                                     const annealing::BondSwitchingOptions& schedule) const {
    AnnealedStart again = candidate;
    again.strain = candidate.deformation * candidate.strain;
    strain(again.level.state, candidate.deformation);
    const TriangleMesh surface = strained(surface_, again.strain);
    annealing::anneal_level(again.level, annealing::TetherSurface(surface, 1),
                            told(judged(schedule, surface), "annealing again"));
    again.released = let_go(again.level.state, surface, again.deformation);
    if (!annealing::holds(again.level)) return candidate;
    return !annealing::holds(candidate.level) || is_better(again.released, candidate.released) ? again
                                                                                               : candidate;
  }

  struct Coarse {
    annealing::AnnealingLevel level;
    Mat3 strain = Mat3::Identity();
    double energy = 0;  // eV an atom, once refined by the first step and let go
  };

  // Relaxed, not annealed.
  void refine(annealing::AnnealingLevel& level, const Step& step,
              const annealing::TetherSurface& surface) const {
    level.state = annealing::refined_by(level.state, step.h, step.k, surface);
    level.state.tether = refined_tether(options_.tether);
    annealing::relax_level(level, surface);
  }

  // Where defects lie well with few atoms they need not with many.
  double energy_refined(const Coarse& coarse, const Path& path) const {
    TriangleMesh surface = strained(surface_, coarse.strain);
    const Step& step = path.steps.front();
    rescale(surface, std::sqrt(static_cast<double>(step.factor()) / static_cast<double>(path.factor)));
    annealing::AnnealingLevel level = coarse.level;
    strain(level.state, coarse.strain);
    refine(level, step, annealing::TetherSurface(surface, 1));
    Mat3 deformation;
    return let_go(level.state, surface, deformation).energy;
  }

  std::optional<Coarse> best_coarse(const Path& path) {
    const double scale = 1 / std::sqrt(static_cast<double>(path.factor));
    const std::size_t atoms = atoms_ / path.factor;
    TriangleMesh surface = surface_;
    rescale(surface, scale);
    const annealing::TetherSurface tether_surface(surface, 1);
    const double tether =
        options_.tether * std::pow(coarse_tether, 0.5 * std::log2(static_cast<double>(path.factor)));
    std::optional<Coarse> best;
    for (int k = 0; k < coarse_starts + (atoms_ < many ? 0 : 1); ++k) {
      const auto attempt = static_cast<std::uint64_t>(k);
      std::optional<annealing::AnnealingLevel> level =
          started(surface, atoms, tether, options_.seed + attempt);
      if (!level || !(level->mean_distance < coarse_distance * scale)) continue;
      annealing::BondSwitchingOptions schedule = judged(hot_schedule_in_cell(atoms, options_), surface);
      schedule.seed += 1000 * attempt;
      annealing::anneal_level(*level, tether_surface, told(schedule, "annealing coarsely"));
      if (!annealing::holds(*level)) continue;
      Coarse coarse{.level = *std::move(level)};
      let_go(coarse.level.state, surface, coarse.strain);
      coarse.energy = energy_refined(coarse, path);
      if (!best || coarse.energy < best->energy) best = std::move(coarse);
    }
    return best;
  }

  // Not annealed at full size.
  std::optional<AnnealedStart> refined(const Path& path) {
    std::optional<Coarse> coarse = best_coarse(path);
    if (!coarse) return {};
    AnnealedStart candidate{.level = std::move(coarse->level), .strain = coarse->strain};
    strain(candidate.level.state, candidate.strain);
    const TriangleMesh surface = strained(surface_, candidate.strain);
    std::size_t left = path.factor;
    for (const Step& step : path.steps) {
      left /= step.factor();
      const annealing::TetherSurface tether_surface(surface, 1 / std::sqrt(static_cast<double>(left)));
      refine(candidate.level, step, tether_surface);
      ++candidate.refinements;
      if (left == 1) break;
      annealing::BondSwitchingOptions schedule = refined_schedule(atoms_ / left, options_);
      schedule.target_atoms = attainable(candidate.level, atoms_ / left);
      annealing::anneal_level(candidate.level, tether_surface, told(schedule, "annealing refined"));
      if (!annealing::holds(candidate.level)) return {};
    }
    candidate.released = let_go(candidate.level.state, surface, candidate.deformation);
    return candidate;
  }

  const TriangleMesh& surface_;
  const std::size_t atoms_;
  const AnnealOptions& options_;
  double seconds_ = 0;  // wall-clock, of remeshing
};

}  // namespace

std::optional<AnnealedStart> start_without_defects(const TriangleMesh& surface, std::size_t atoms,
                                                   const AnnealOptions& options) {
  const std::optional<TriangleMesh> triangulation = crystal::hexagonal_triangulation(surface, atoms);
  if (!triangulation) return {};
  auto level = annealing::level_on(*triangulation, level_options(options));
  if (!level) return {};
  annealing::relax_level(*level, annealing::TetherSurface(surface, 1));
  if (!annealing::holds(*level)) return {};
  AnnealedStart candidate{.level = *std::move(level)};
  candidate.released =
      spring_back_in_cell(candidate.level.state, surface, options.relax_cell, candidate.deformation);
  return candidate;
}

BestStart best_start_in_cell(annealing::AnnealingLevel direct, const TriangleMesh& surface, std::size_t atoms,
                             const AnnealOptions& options) {
  return Annealing(surface, atoms, options).best(std::move(direct));
}

}  // namespace nanocarbon::building
