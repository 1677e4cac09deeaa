#include "nanocarbon/relaxation/anneal_recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "nanocarbon/core/error.h"
#include "nanocarbon/relaxation/annealing_level.h"
#include "nanocarbon/relaxation/geometry_check.h"
#include "nanocarbon/relaxation/minimise_rebo2.h"
#include "nanocarbon/relaxation/refine_network.h"
#include "nanocarbon/relaxation/spring_back.h"

namespace nanocarbon {

namespace {

constexpr std::size_t kCoarsest = 225;  // atoms: fewer cannot show a shape, and cost more for each

// Atoms up to which a hot start at full size is affordable where no coarser one is of use: a long one where
// none was tried. Below the other number a short one must do everywhere.
constexpr std::size_t kSmall = 1800, kTiny = 400;

// A coarse sheet is the stiffer one for its size: it is held to the surface by more than the tether that was
// asked for, by this for each refinement. What is refined from it has its order already and is held by this
// share of the default tether, so that it can buckle where that is cheaper, and by all that is asked beyond.
constexpr double kCoarseTether = 3, kRefinedTether = 0.2;

// Atoms farther from the surface than this in the mean, multiplied up to the full size, have lost the shape,
// and so have those beyond which the surface reaches farther than this, at the start and once annealed,
// Angstrom at full size.
constexpr double kCoarseDistance = 3, kLostAtStart = 8, kLostInTheEnd = 10;

// Of molecules from several starts the one with the least energy is best, but for being farther from the
// surface than this in the mean, Angstrom, which has a price, eV for each atom and Angstrom. A tether stiffer
// than the default makes that distance shorter in proportion and the price higher, for each eV/Angstrom^2.
constexpr double kNear = 1, kDistancePrice = 0.03, kTetherPrice = 1.0 / 3;
// Annealing at full size hardly ever leaves less than this of a start's energy above graphene.
constexpr double kLeastLeft = 0.75;

// Spring-back from the surface that is left as it is, Angstrom, and the price of more of it, eV for each atom
// and Angstrom: what further annealing against it may cost.
constexpr double kFineDistance = 0.8, kSpringBackPrice = 0.01;
constexpr int kCompensations = 2;

constexpr int kMendings = 2;

// A molecule that lacks no more than to come closer to the surface, and what it is once it is let go.
struct Candidate {
  AnnealingLevel level;
  SpringBack rest;
  int refinements = 0;
};

// The starts that are made at one coarse level.
struct CoarseLevels {
  int refinements;
  int attempts;        // at most, with a seed each, and as many times annealed
  int attempt = 0;     // under way
  int annealed = 0;    // so far
  bool roomy = false;  // thin parts are made as thick as this level needs, from now on
};

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
      : surface_(with_room(surface, options)), atoms_(atoms), triangulate_(triangulate), options_(options) {}

  AnnealResult run() {
    AnnealResult result;
    AnnealingLevel level = full_size_level();
    relax_level(level, TetherSurface(surface_, 1));
    result.unannealed_energy = level.unannealed;
    if (options_.quality != AnnealQuality::draft) {
      Candidate best = best_candidate(std::move(level));
      result.refinements = best.refinements;
      come_closer(best);
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

  TriangleMesh scaled_surface(int refinements) const {
    TriangleMesh surface = surface_;
    for (Vec3& p : surface.points) p *= scale(refinements);
    return surface;
  }

  BondSwitchingOptions switching(std::size_t target) const {
    BondSwitchingOptions switching;
    switching.target_atoms = target;
    switching.seed = options_.seed;
    switching.threads = options_.threads;
    switching.cold = 0.2;
    return switching;
  }

  AnnealingLevel full_size_level() const {
    constexpr std::uint64_t seeds = 4;
    for (std::uint64_t k = 0; k < seeds; ++k)
      if (auto level = level_on(triangulate_(surface_, atoms_, options_.seed + k), options_.tether,
                                !options_.keep_size))
        return *std::move(level);
    throw UserError(Failure::size,
                    fmt::format("{} atoms are too few for the thinnest parts of the surface: its "
                                "triangulation pinches them; ask for more atoms",
                                atoms_));
  }

  void tell(std::string_view stage, double share) const {
    if (options_.progress) options_.progress(stage, share);
  }

  // From where defects move freely.
  static void make_hot(BondSwitchingOptions& switching, bool at_length) {
    switching.hot = at_length ? 0.6 : 0.5;
    switching.blocks = at_length ? 36 : 24;
  }

  // Cooling from where defects just begin to move freely: a crystal's order over long ranges survives it.
  // Small molecules have none to lose. \param alone no refined start has come about
  BondSwitchingOptions single_level_switching(bool alone) const {
    BondSwitchingOptions single = switching(atoms_);
    single.hot = 0.35;
    single.blocks = 12;
    if (alone && atoms_ < kSmall)
      make_hot(single, atoms_ >= kTiny && refinements_for(atoms_, options_.quality) == 0);
    if (options_.quality == AnnealQuality::best) single.blocks = 48;
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

  // Anneals starts refined from coarser levels, and one at full size unless it cannot win, and takes the
  // best. Smooth shapes gain much by refining: what lies far apart comes to order. Shapes with thin parts do
  // not show them at a quarter of the atoms.
  Candidate best_candidate(AnnealingLevel direct) {
    std::optional<Candidate> best;
    for (int refinements = refinements_for(atoms_, options_.quality); refinements > 0; --refinements) {
      CoarseLevels coarse{refinements, options_.quality == AnnealQuality::best ? 4 : 2};
      for (; coarse.attempt < coarse.attempts && coarse.annealed < coarse.attempts; ++coarse.attempt) {
        auto candidate = refined_candidate(coarse, direct.unannealed);
        if (candidate && (!best || merit(candidate->rest) < merit(best->rest))) best = std::move(candidate);
      }
      if (best && best->rest.mean_distance < near()) break;
    }
    if (best && !may_become_better(direct, *best)) return *std::move(best);
    anneal_level(direct, TetherSurface(surface_, 1), single_level_switching(!best));
    Candidate candidate = released(std::move(direct), 0);
    if (best && (!holds(candidate.level) || merit(best->rest) <= merit(candidate.rest)))
      return *std::move(best);
    return candidate;
  }

  bool may_become_better(const AnnealingLevel& direct, const Candidate& best) const {
    SpringBack least = spring_back(direct.state, TetherSurface(surface_, 1), !options_.keep_size);
    least.energy = graphene_energy + kLeastLeft * (least.energy - graphene_energy);
    least.mean_distance = 0;
    return merit(least) < merit(best.rest);
  }

  double merit(const SpringBack& rest) const {
    const double price = kDistancePrice + kTetherPrice * std::max(0.0, options_.tether - default_tether);
    return rest.energy + price * std::max(rest.mean_distance, near());
  }

  double near() const { return kNear * std::min(1.0, default_tether / options_.tether); }

  double refined_tether() const {
    return options_.tether - (1 - kRefinedTether) * std::min(options_.tether, default_tether);
  }

  Candidate released(AnnealingLevel level, int refinements) const {
    SpringBack rest = spring_back(level.state, TetherSurface(surface_, 1), !options_.keep_size);
    return {std::move(level), std::move(rest), refinements};
  }

  // Annealed at a coarser level, refined and annealed shortly on the way. Nothing where the shape is not
  // held, or where there is nothing to gain over a start at full size of the given energy.
  std::optional<Candidate> refined_candidate(CoarseLevels& coarse, double direct) const {
    std::optional<AnnealingLevel> level = coarse_level(coarse);
    const bool once_more = !level && !coarse.roomy && coarse.annealed < coarse.attempts;
    if (once_more && options_.make_room && options_.make_room(scaled_surface(coarse.refinements))) {
      coarse.roomy = true;
      level = coarse_level(coarse);
    }
    for (int left = coarse.refinements - 1; left >= 0 && level; --left) {
      const TetherSurface tether_surface(surface_, scale(left));
      level->state = refined_in_four(level->state, tether_surface);
      level->state.tether = refined_tether();
      relax_level(*level, tether_surface);
      if (left == 0 && level->unannealed > direct) return {};
      anneal_level(*level, tether_surface, fine_switching(left));
      // An overstretched bond is mostly mended by annealing; where not, without refining.
      if (!holds(*level)) return {};
    }
    if (!level) return {};
    return released(*std::move(level), coarse.refinements);
  }

  // Nothing where there are too few atoms for the surface's topology.
  std::optional<AnnealingLevel> coarse_start(const TriangleMesh& surface, int refinements,
                                             int attempt) const {
    const double tether = options_.tether * std::pow(kCoarseTether, refinements);
    try {
      return level_on(
          triangulate_(surface, atoms(refinements), options_.seed + static_cast<std::uint64_t>(attempt)),
          tether, !options_.keep_size);
    } catch (const UserError&) {
      return {};
    }
  }

  // Nothing where the shape is not held.
  std::optional<AnnealingLevel> coarse_level(CoarseLevels& coarse) const {
    const int refinements = coarse.refinements;
    TriangleMesh surface = scaled_surface(refinements);
    if (coarse.roomy) surface = with_room(surface, options_);
    const TetherSurface tether_surface(surface, 1);
    std::optional<AnnealingLevel> level = coarse_start(surface, refinements, coarse.attempt);
    if (!level) return {};
    relax_level(*level, tether_surface);
    if (!shows_shape(*level, surface, refinements, kLostAtStart)) return {};
    BondSwitchingOptions hot = switching(atoms(refinements));
    make_hot(hot, atoms(refinements) >= kTiny);
    hot.seed += 1000 * static_cast<std::uint64_t>(coarse.attempt);
    hot.progress = [&](int block, double, std::size_t, std::size_t) {
      tell("annealing coarsely", (coarse.annealed + (block + 1.0) / hot.blocks) / coarse.attempts);
    };
    anneal_level(*level, tether_surface, hot);
    ++coarse.annealed;
    if (!holds(*level) || lost_reach(*level, surface) > kLostInTheEnd * scale(refinements)) return {};
    return level;
  }

  // A coarse level is of use only if its atoms still lie on the surface and leave none of it out, by the
  // measure of the level.
  bool shows_shape(const AnnealingLevel& level, const TriangleMesh& surface, int refinements,
                   double most_lost) const {
    return level.mean_distance < kCoarseDistance * scale(refinements) &&
           lost_reach(level, surface) < most_lost * scale(refinements);
  }

  // Where the molecule springs back too far once it is let go, switches more bonds while it is held on the
  // other side; keeps what that gains.
  void come_closer(Candidate& best) {
    const auto merit_of = [](const SpringBack& b) {
      return b.energy + kSpringBackPrice * std::max(b.mean_distance, kFineDistance);
    };
    for (int round = 0; round < kCompensations && best.rest.mean_distance > kFineDistance; ++round) {
      const double former_growth = growth_;
      AnnealingLevel closer = best.level;
      compensate(closer.state, best.rest);
      const double factor = std::sqrt(1 / best.rest.fit.scale);
      grow(factor);
      for (Vec3& p : closer.state.positions) p *= factor;
      BondSwitchingOptions again = switching(atoms_);
      again.hot = 0.3;
      again.blocks = 4;
      again.trials_per_defect = 60;
      again.seed += 10000 + static_cast<std::uint64_t>(round);
      anneal_level(closer, TetherSurface(surface_, 1), again);
      Candidate then = released(std::move(closer), best.refinements);
      if (merit_of(then.rest) >= merit_of(best.rest)) {
        grow(former_growth / growth_);
        break;
      }
      best = std::move(then);
    }
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

  void finish(AnnealingLevel& level, AnnealResult& result) {
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
