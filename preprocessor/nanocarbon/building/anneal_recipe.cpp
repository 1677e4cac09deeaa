// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/anneal_recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "nanocarbon/annealing/annealing_level.h"
#include "nanocarbon/annealing/geometry_check.h"
#include "nanocarbon/annealing/refine_network.h"
#include "nanocarbon/annealing/surface_fit.h"
#include "nanocarbon/building/annealing_schedules.h"
#include "nanocarbon/building/coarse_starts.h"
#include "nanocarbon/building/spring_back.h"
#include "nanocarbon/building/start_choice.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/periodic_mesh.h"
#include "nanocarbon/minimisation/minimise_molecule.h"
#include "nanocarbon/potential/rebo2/parameters.h"

namespace nanocarbon::building {

namespace {

// What is refined from a coarse level has its order already and is held by this share of the default tether,
// so that it can buckle where that is cheaper, and by all that is asked beyond.
constexpr double refined_tether_share = 0.2;

// Annealing at full size hardly ever leaves less than this of a start's energy above graphene, or of its
// distance to the surface.
constexpr double least_left = 0.75;

constexpr int mendings = 2;

// A cell narrower than this has vertices that meet through two images, and levels in it are not tried. Angstrom.
constexpr double least_width = 9;

// An annealed molecule at full size, and what it is once it is let go.
struct Candidate {
  annealing::AnnealingLevel level;
  Released rest;
  int refinements = 0;
};

class Recipe {
 public:
  Recipe(const TriangleMesh& surface, std::size_t atoms, const Triangulator& triangulate,
         potential::Potential& potential, const AnnealOptions& options)
      : surface_(with_room(surface, options)),
        atoms_(atoms),
        triangulate_(triangulate),
        potential_(potential),
        options_(options) {}

  AnnealResult run() {
    AnnealResult result;
    annealing::AnnealingLevel level = full_size_level();
    annealing::relax_level(level, annealing::TetherSurface(surface_, 1));
    result.unannealed_energy = level.unannealed;
    if (options_.quality != Quality::draft) {
      Candidate best = best_candidate(std::move(level));
      result.refinements = best.refinements;
      level = std::move(best.level);
    }
    finish(level, result);
    return result;
  }

 private:
  static TriangleMesh with_room(const TriangleMesh& surface, const AnnealOptions& options) {
    if (options.make_room)
      if (auto roomy = options.make_room(surface)) return *std::move(roomy);
    return surface;
  }

  double scale(int refinements) const { return std::ldexp(1.0, -refinements); }
  std::size_t atoms(int refinements) const { return atoms_ >> (2 * refinements); }

  annealing::AnnealingLevel full_size_level() const {
    constexpr std::uint64_t seeds = 4;
    for (std::uint64_t k = 0; k < seeds; ++k)
      if (auto level = annealing::level_on(triangulate_(surface_, atoms_, options_.seed + k), options_.tether,
                                           !options_.keep_size))
        return *std::move(level);
    throw UserError(Failure::size,
                    fmt::format("{} atoms are too few for the thinnest parts of the surface: its "
                                "triangulation pinches them",
                                atoms_));
  }

  void tell(std::string_view stage, double share) const {
    if (options_.progress) options_.progress(stage, share);
  }

  // With the progress of this stage told.
  annealing::BondSwitchingOptions told(annealing::BondSwitchingOptions schedule,
                                       std::string_view stage) const {
    schedule.progress = [this, stage, blocks = schedule.blocks](int block, double, std::size_t, std::size_t) {
      tell(stage, (block + 1.0) / blocks);
    };
    return schedule;
  }

  // Anneals starts refined from coarser levels, and one at full size unless it cannot win, and takes the
  // best. Smooth shapes gain much by refining: what lies far apart comes to order. Shapes with thin parts do
  // not show them at a quarter of the atoms.
  Candidate best_candidate(annealing::AnnealingLevel direct) {
    std::optional<Candidate> best;
    int most = refinements_for(atoms_, options_.quality);
    while (most > 0 && surface_.space.least_width() * scale(most) < least_width) --most;
    for (int refinements = most; refinements > 0; --refinements) {
      CoarseStarts starts(surface_, atoms_, refinements, triangulate_, options_);
      while (starts.left()) {
        auto candidate = refined_candidate(starts.next(), refinements, direct.unannealed);
        if (candidate && (!best || is_better(candidate->rest, best->rest))) best = std::move(candidate);
      }
      if (best && is_near(best->rest, options_.tether)) break;
    }
    if (best && !may_become_better(direct, *best)) return *std::move(best);
    annealing::anneal_level(direct, annealing::TetherSurface(surface_, 1),
                            told(full_size_schedule(atoms_, !best, options_), "annealing"));
    Candidate candidate = released(std::move(direct), 0);
    if (best && (!annealing::holds(candidate.level) || !is_better(candidate.rest, best->rest)))
      return *std::move(best);
    return candidate;
  }

  bool may_become_better(const annealing::AnnealingLevel& direct, const Candidate& best) const {
    Released least = spring_back(direct.state, annealing::TetherSurface(surface_, 1), !options_.keep_size);
    least.energy = rebo2::graphene_energy + least_left * (least.energy - rebo2::graphene_energy);
    least.mean_distance *= least_left;
    return is_better(least, best.rest);
  }

  bool is_better(const Released& one, const Released& other) const {
    return building::is_better(one, other, options_.tether);
  }

  double refined_tether() const {
    return options_.tether - (1 - refined_tether_share) * std::min(options_.tether, default_tether);
  }

  Candidate released(annealing::AnnealingLevel level, int refinements) const {
    Released rest = spring_back(level.state, annealing::TetherSurface(surface_, 1), !options_.keep_size);
    return {std::move(level), std::move(rest), refinements};
  }

  // Refined to full size and annealed shortly on the way. Nothing where bonds do not hold, or where there is
  // nothing to gain over a start at full size of the given energy.
  std::optional<Candidate> refined_candidate(std::optional<annealing::AnnealingLevel> level, int refinements,
                                             double direct) const {
    for (int left = refinements - 1; left >= 0 && level; --left) {
      const annealing::TetherSurface tether_surface(surface_, scale(left));
      level->state = annealing::refined_in_four(level->state, tether_surface);
      level->state.tether = refined_tether();
      annealing::relax_level(*level, tether_surface);
      if (left == 0 && level->unannealed > direct) return {};
      annealing::anneal_level(*level, tether_surface,
                              told(refined_schedule(atoms(left), options_), "annealing refined"));
      // An overstretched bond is mostly mended by annealing; where not, without refining.
      if (!annealing::holds(*level)) return {};
    }
    if (!level) return {};
    return released(*std::move(level), refinements);
  }

  // Moves the molecule to where it fits the surface best, of the size that fits it.
  void align(AnnealResult& result) const {
    std::vector<Vec3>& positions = result.molecule.positions;
    TriangleMesh surface = surface_;
    if (surface.space.periodic()) mesh::deform(surface, result.deformation);
    const annealing::Similarity fit =
        annealing::fit_to_surface(positions, annealing::TetherSurface(surface, 1), !options_.keep_size);
    result.growth = 1 / fit.scale;
    for (Vec3& p : positions) p = fit(p) / fit.scale;
    const annealing::TetherSurface tether_surface(surface, result.growth);
    result.mean_distance = 0;
    for (const Vec3& p : positions)
      result.mean_distance += tether_surface.distance(p) / static_cast<double>(positions.size());
  }

  // With the cell's strains that are freed.
  minimisation::MinimisationResult minimise(AnnealResult& result) const {
    const minimisation::MinimisationOptions wanted{.force_tolerance = options_.force_tolerance};
    if (!result.molecule.cell) return minimisation::minimise_molecule(result.molecule, potential_, wanted);
    const minimisation::CellMinimum relaxed =
        minimisation::minimise_in_cell(result.molecule, potential_, options_.relax_cell, wanted);
    result.deformation = relaxed.deformation;
    result.stress = relaxed.stress;
    return relaxed.minimum;
  }

  void finish(annealing::AnnealingLevel& level, AnnealResult& result) const {
    tell("minimising", 0);
    annealing::FixedBondModel model;
    for (int attempt = 0; attempt <= mendings && !result.intact; ++attempt) {
      if (attempt > 0) {
        level.sound = false;
        annealing::mend_level(level, annealing::TetherSurface(surface_, 1), schedule_for(atoms_, options_));
      }
      // Without the tether, still on fixed bonds: the way to the minimum may stretch bonds that the end does
      // not. For the rest of the way the full potential is as safe and faster; where it was not, again.
      model = {};
      model.rebo2.set_graph(annealing::fixed_bond_graph(level.state.network, level.state.space));
      std::vector<Vec3> positions = level.state.positions;
      annealing::minimise_fixed_bonds(
          model, nullptr, positions,
          {.max_iterations = 2000, .force_tolerance = (attempt == 0 ? 50 : 3) * options_.force_tolerance});
      result.molecule = annealing::molecule_of(level.state.network, positions, level.state.space);
      const auto relaxed = minimise(result);
      result.energy = relaxed.energy / static_cast<double>(result.molecule.size());
      result.max_force = relaxed.max_force;
      result.intact = relaxed.intact;
    }
    result.accepted = level.accepted;
    result.network = level.state.network;
    const annealing::GeometryCheck check =
        annealing::check_geometry(result.molecule.positions, annealing::fixed_bond_graph(result.molecule));
    result.shortest_bond = check.shortest_bond;
    result.longest_bond = check.longest_bond;
    result.closest_unbonded = check.closest_unbonded;
    align(result);
  }

  const TriangleMesh surface_;  // Angstrom, with room for the molecule
  const std::size_t atoms_;
  const Triangulator& triangulate_;
  potential::Potential& potential_;
  const AnnealOptions& options_;
};

}  // namespace

AnnealResult anneal(const TriangleMesh& surface, std::size_t atoms, const Triangulator& triangulate,
                    potential::Potential& potential, const AnnealOptions& options) {
  return Recipe(surface, atoms, triangulate, potential, options).run();
}

}  // namespace nanocarbon::building
