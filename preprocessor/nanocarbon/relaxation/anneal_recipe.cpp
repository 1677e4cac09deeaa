#include "nanocarbon/relaxation/anneal_recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "nanocarbon/core/error.h"
#include "nanocarbon/relaxation/bond_switching.h"
#include "nanocarbon/relaxation/dual_relaxation.h"
#include "nanocarbon/relaxation/geometry_check.h"
#include "nanocarbon/relaxation/minimise_rebo2.h"
#include "nanocarbon/relaxation/refine_network.h"
#include "nanocarbon/relaxation/spring_back.h"

namespace nanocarbon {

namespace {

constexpr std::size_t kCoarsest = 200;  // atoms: fewer cannot show a shape

constexpr std::size_t kSmall = 1800;  // atoms up to which a hot start at full size is affordable

// Atoms farther from the surface than this in the mean, multiplied up to the full size, have lost the shape,
// Angstrom.
constexpr double kCoarseDistance = 3;

// Spring-back from the surface that is left as it is, Angstrom, and the price of more of it, eV for each atom
// and Angstrom: what decides between two molecules.
constexpr double kFineDistance = 0.8, kDistancePrice = 0.01;
// Likewise of two starts, for each eV/Angstrom^2 of tether beyond the default.
constexpr double kStartPrice = 1.0 / 3;
constexpr int kCompensations = 2;

// What REBO2 must see, with a margin for what happens when the tether goes: whole bonds end at 1.7 Angstrom,
// and other atoms are seen from 2.0.
constexpr double kSafeBond = 1.66, kSafeDistance = 2.05;
constexpr int kMendings = 2;

struct Level {
  SwitchingState state;
  double unannealed = 0;  // eV for each atom
  double energy = 0;      // eV for each atom, with tether
  std::size_t accepted = 0;
  double mean_distance = 0;  // of the atoms to the surface, Angstrom
  bool sound = false;
};

// Nothing where parts are so thin for the number of atoms that a triangulation pinches them.
std::optional<Level> try_start(const TriangleMesh& surface, double scale, std::size_t atoms,
                               const Triangulator& triangulate, const AnnealOptions& options,
                               std::uint64_t seed) {
  Level level;
  TriangleMesh mesh = triangulate(surface, atoms, seed);
  for (Vec3& p : mesh.points) p *= scale;
  try {
    level.state.network = trivalent_network(mesh);
  } catch (const UserError&) {
    return {};
  }
  for (const Triangle& t : mesh.triangles)
    level.state.positions.push_back((mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3);
  level.state.tether = options.tether;
  level.state.free_mean = !options.keep_size;
  return level;
}

bool is_safe(double longest_bond, double closest_unbonded) {
  return longest_bond < kSafeBond && closest_unbonded > kSafeDistance;
}

// As it is now; Level::sound is as of its last relaxation.
bool holds(const Level& level) {
  const GeometryCheck check = check_geometry(level.state.positions, fixed_bond_graph(level.state.network));
  return is_safe(check.longest_bond, check.closest_unbonded);
}

void relax_level(Level& level, const TetherSurface& tether_surface, bool raw = true) {
  const auto relaxed =
      relax_network(fixed_bond_graph(level.state.network), level.state.positions, tether_surface,
                    {.tether = level.state.tether,
                     .untangling_attempts = raw ? 1u : 0u,
                     .free_mean = level.state.free_mean,
                     .springs_first = raw});
  level.unannealed = relaxed.energy / static_cast<double>(level.state.positions.size());
  level.mean_distance = relaxed.mean_distance;
  level.sound = is_safe(relaxed.longest_bond, relaxed.closest_unbonded);
}

// Switches bonds until REBO2 would see the bonds that are meant, a little at a time and without heat.
void mend_level(Level& level, const TetherSurface& tether_surface, BondSwitchingOptions options) {
  options.hot = options.cold = 0.2;
  options.blocks = 1;
  options.trials_per_defect = 5;
  options.tether = level.state.tether;
  for (int round = 0; round < 4 && !level.sound; ++round) {
    options.seed += 100;
    level.accepted += anneal_bonds(level.state, tether_surface, options).accepted;
    relax_level(level, tether_surface, false);
  }
}

void anneal_level(Level& level, const TetherSurface& tether_surface, BondSwitchingOptions options) {
  options.tether = level.state.tether;
  const BondSwitchingResult result = anneal_bonds(level.state, tether_surface, options);
  level.energy = result.energy;
  level.accepted += result.accepted;
}

int refinements_for(std::size_t atoms, AnnealQuality quality) {
  if (quality == AnnealQuality::draft) return 0;
  int levels = 0;
  while (levels < 2 && (atoms >> (2 * (levels + 1))) >= kCoarsest) ++levels;
  return levels;
}

class Recipe {
 public:
  Recipe(const TriangleMesh& surface, std::size_t atoms, const Triangulator& triangulate,
         const AnnealOptions& options)
      : surface_(surface), atoms_(atoms), triangulate_(triangulate), options_(options) {}

  AnnealResult run() {
    AnnealResult result;
    Level level = full_size_level();
    relax_level(level, TetherSurface(surface_, 1));
    result.unannealed_energy = level.unannealed;
    if (options_.quality != AnnealQuality::draft) {
      const Level direct = level;
      result.refinements = begin_coarse(level);
      if (result.refinements > 0) anneal_level(level, TetherSurface(surface_, 1), fine_switching(0));
      // A bond that refining has overstretched is mostly mended by annealing; where not, without refining.
      if (result.refinements > 0 && !level.sound && !holds(level)) {
        level = direct;
        result.refinements = 0;
      }
      if (result.refinements == 0) anneal_level(level, TetherSurface(surface_, 1), single_level_switching());
      come_closer(level);
    }
    finish(level, result);
    return result;
  }

 private:
  double scale(int refinements) const { return std::ldexp(1.0, -refinements); }
  std::size_t atoms(int refinements) const { return atoms_ >> (2 * refinements); }

  BondSwitchingOptions switching(std::size_t target) const {
    BondSwitchingOptions switching;
    switching.target_atoms = target;
    switching.seed = options_.seed;
    switching.threads = options_.threads;
    switching.cold = 0.2;
    return switching;
  }

  Level full_size_level() const {
    constexpr std::uint64_t seeds = 4;
    for (std::uint64_t k = 0; k < seeds; ++k)
      if (auto level = try_start(surface_, 1, atoms_, triangulate_, options_, options_.seed + k))
        return *level;
    throw UserError(Failure::size,
                    fmt::format("{} atoms are too few for the thinnest parts of the surface: its "
                                "triangulation pinches them; ask for more atoms",
                                atoms_));
  }

  void tell(std::string_view stage, double share) const {
    if (options_.progress) options_.progress(stage, share);
  }

  // Cooling from where defects just begin to move freely: a crystal's order over long ranges survives it.
  BondSwitchingOptions single_level_switching() const {
    BondSwitchingOptions single = switching(atoms_);
    single.hot = atoms_ < kSmall ? 0.5 : 0.35;
    single.blocks = options_.quality == AnnealQuality::best ? 48 : atoms_ < kSmall ? 24 : 12;
    single.progress = [this, blocks = single.blocks](int block, double, std::size_t, std::size_t) {
      tell("annealing", (block + 1.0) / blocks);
    };
    return single;
  }

  BondSwitchingOptions fine_switching(int left) const {
    BondSwitchingOptions fine = switching(atoms(left));
    fine.hot = 0.35;
    fine.blocks = options_.quality == AnnealQuality::best ? 16 : 8;
    fine.trials_per_defect = 60;
    fine.progress = [this, blocks = fine.blocks](int block, double, std::size_t, std::size_t) {
      tell("annealing refined", (block + 1.0) / blocks);
    };
    return fine;
  }

  // Replaces a start at full size by one refined from annealed coarser ones, where that has less energy:
  // smooth shapes gain much by it, shapes with thin parts do not show them at a quarter of the atoms. Returns
  // the refinements.
  int begin_coarse(Level& direct) {
    for (int refinements = refinements_for(atoms_, options_.quality); refinements > 0; --refinements) {
      std::optional<Level> level = coarse_level(refinements);
      for (int left = refinements - 1; left >= 0 && level; --left) {
        const TetherSurface tether_surface(surface_, scale(left));
        level->state = refined_in_four(level->state, tether_surface);
        level->state.tether = options_.tether;
        relax_level(*level, tether_surface);
        if (left == 0) break;  // run() anneals it, and looks
        anneal_level(*level, tether_surface, fine_switching(left));
        if (!level->sound && !holds(*level)) level.reset();
      }
      if (!level || start_merit(*level) > start_merit(direct)) continue;
      direct = std::move(*level);
      return refinements;
    }
    return 0;
  }

  // Coarse sheets are the stiffer ones: they swell where they are bent and round off what is small, and so
  // does what is refined from them. That counts where a stiff tether is asked for, or a size.
  double start_merit(const Level& level) const {
    return level.unannealed +
           kStartPrice * std::max(0.0, options_.tether - default_tether) * level.mean_distance;
  }

  // The best of several annealed starts at a coarser level, or nothing where the shape is not held there.
  std::optional<Level> coarse_level(int refinements) {
    const TetherSurface tether_surface(surface_, scale(refinements));
    const int attempts = options_.quality == AnnealQuality::best ? 4 : 2;
    std::optional<Level> best;
    for (int attempt = 0; attempt < attempts; ++attempt) {
      std::optional<Level> start = try_start(surface_, scale(refinements), atoms(refinements), triangulate_,
                                             options_, options_.seed + static_cast<std::uint64_t>(attempt));
      if (!start) return {};
      Level& level = *start;
      relax_level(level, tether_surface);
      if (!level.sound || !shows_shape(level, refinements)) return {};
      BondSwitchingOptions coarse = switching(atoms(refinements));
      coarse.hot = 0.5;
      coarse.blocks = 24;
      coarse.seed += 1000 * static_cast<std::uint64_t>(attempt);
      coarse.progress = [&](int block, double, std::size_t, std::size_t) {
        tell("annealing coarsely", (attempt + (block + 1.0) / coarse.blocks) / attempts);
      };
      anneal_level(level, tether_surface, coarse);
      if (!best || level.energy < best->energy) best = std::move(level);
    }
    return best;
  }

  // A coarse level is of use only if its atoms still lie on the surface, by the measure of the level.
  static bool shows_shape(const Level& level, int refinements) {
    return std::ldexp(level.mean_distance, refinements) < kCoarseDistance;
  }

  // Where the molecule springs back too far once it is let go, switches more bonds while it is held on the
  // other side; keeps what that gains.
  void come_closer(Level& level) {
    SpringBack now = spring_back(level.state, TetherSurface(surface_, 1), !options_.keep_size);
    for (int round = 0; round < kCompensations && now.mean_distance > kFineDistance; ++round) {
      const double former_growth = growth_;
      Level closer = level;
      compensate(closer.state, now);
      const double factor = std::sqrt(1 / now.fit.scale);
      grow(factor);
      for (Vec3& p : closer.state.positions) p *= factor;
      BondSwitchingOptions again = switching(atoms_);
      again.hot = 0.3;
      again.blocks = 4;
      again.trials_per_defect = 60;
      again.seed += 10000 + static_cast<std::uint64_t>(round);
      anneal_level(closer, TetherSurface(surface_, 1), again);
      const SpringBack then = spring_back(closer.state, TetherSurface(surface_, 1), !options_.keep_size);
      if (merit(then) >= merit(now)) {
        grow(former_growth / growth_);
        break;
      }
      level = std::move(closer);
      now = then;
    }
  }

  static double merit(const SpringBack& b) {
    return b.energy + kDistancePrice * std::max(b.mean_distance, kFineDistance);
  }

  void grow(double factor) {
    growth_ *= factor;
    for (Vec3& p : surface_.points) p *= factor;
  }

  // Moves the molecule to where it fits the surface best, and the surface to the size that fits it.
  void align(AnnealResult& result) {
    std::vector<Vec3>& positions = result.molecule.positions;
    const Similarity fit = fit_to_surface(positions, TetherSurface(surface_, 1), !options_.keep_size);
    grow(1 / fit.scale);
    for (Vec3& p : positions) p = fit(p) / fit.scale;
    result.growth = growth_;
    const TetherSurface tether_surface(surface_, 1);
    result.mean_distance = 0;
    for (const Vec3& p : positions)
      result.mean_distance += tether_surface.distance(p) / static_cast<double>(positions.size());
  }

  void finish(Level& level, AnnealResult& result) {
    tell("minimising", 0);
    FixedBondModel model;
    for (int attempt = 0; attempt <= kMendings && !result.intact; ++attempt) {
      if (attempt > 0) {
        level.sound = false;
        mend_level(level, TetherSurface(surface_, 1), switching(atoms_));
      }
      // Without the tether, still on fixed bonds: the way to the minimum may stretch bonds that the end does
      // not. For the rest of the way the full potential is as safe and faster; where it was not, again.
      model = {};
      model.rebo2.set_graph(fixed_bond_graph(level.state.network));
      std::vector<Vec3> positions = level.state.positions;
      minimise_fixed_bonds(
          model, nullptr, positions,
          {.max_iterations = 2000, .force_tolerance = (attempt == 0 ? 50 : 3) * options_.force_tolerance});
      result.molecule = molecule_of(level.state.network, positions);
      const auto relaxed = minimise_rebo2(result.molecule, {.force_tolerance = options_.force_tolerance});
      result.energy = relaxed.energy / static_cast<double>(result.molecule.size());
      result.max_force = relaxed.max_force;
      result.intact = relaxed.intact;
    }
    result.accepted = level.accepted;
    result.network = level.state.network;
    const GeometryCheck check = check_geometry(result.molecule.positions, model.rebo2.graph());
    result.shortest_bond = check.shortest_bond;
    result.longest_bond = check.longest_bond;
    result.closest_unbonded = check.closest_unbonded;
    align(result);
  }

  TriangleMesh surface_;  // Angstrom; grows until it fits the molecule
  double growth_ = 1;
  const std::size_t atoms_;
  const Triangulator& triangulate_;
  const AnnealOptions& options_;
};

}  // namespace

AnnealResult anneal(const TriangleMesh& surface, std::size_t atoms, const Triangulator& triangulate,
                    const AnnealOptions& options) {
  return Recipe(surface, atoms, triangulate, options).run();
}

}  // namespace nanocarbon
