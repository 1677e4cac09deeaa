// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/bond_switching.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "nanocarbon/annealing/refused_switches.h"
#include "nanocarbon/annealing/switching_trial.h"
#include "nanocarbon/core/thread_team.h"
#include "nanocarbon/potential/rebo2/parameters.h"
#include "nanocarbon/topology/bond_shells.h"

namespace nanocarbon::annealing {

namespace {

constexpr std::size_t batch = 8;  // trials on one state; fixed, so that threads do not change the outcome

// A hundredth more or less than the target costs 20 eV, but a single pair of atoms may come and go in small
// molecules.
double default_penalty(double target) {
  return std::max(1 / target, std::min(200000 / (target * target), 0.05));
}

// A chain of the boundary and what lies beside it along the boundary.
struct ChainPlace {
  RingIndex before, after;
};

ChainPlace chain_place(const TrivalentNetwork& network, RingIndex chain) {
  std::vector<AtomIndex> atoms;
  std::vector<RingIndex> link;
  link_of(network, chain, atoms, link);
  return {link.front(), link.back()};
}

// Part of a straight zigzag or armchair edge.
bool is_regular(const TrivalentNetwork& network, RingIndex chain) {
  const std::uint32_t size = network.rings[chain].size;
  if (size < 2 || size > 4) return false;
  const ChainPlace place = chain_place(network, chain);
  return network.rings[place.before].size == 6 - size && network.rings[place.after].size == 6 - size;
}

// Indices with constant-time updates and an order that depends only on the history.
class IndexList {
 public:
  void update(RingIndex ring, bool wanted) {
    if (place_.size() <= ring) place_.resize(ring + std::size_t{1}, none);
    if (wanted == (place_[ring] != none)) return;
    if (wanted) {
      place_[ring] = list_.size();
      list_.push_back(ring);
    } else {
      list_[place_[ring]] = list_.back();
      place_[list_.back()] = place_[ring];
      list_.pop_back();
      place_[ring] = none;
    }
  }
  const std::vector<RingIndex>& list() const { return list_; }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<RingIndex> list_;
  std::vector<std::size_t> place_;
};

// Bonds from the atoms around which defects are tried to the farthest that are.
constexpr unsigned farthest_tried = 10;

// Atoms within so many bonds of some; all of them where there are none.
std::vector<bool> atoms_around(const TrivalentNetwork& network, std::span<const AtomIndex> some) {
  std::vector<bool> found(network.atoms.size(), some.empty());
  std::vector<AtomIndex> reached;
  const topology::FirstTime first(found);
  std::copy_if(some.begin(), some.end(), std::back_inserter(reached), first);
  const auto neighbours_of = [&](AtomIndex a) { return network.atoms[a].neighbour; };
  std::size_t shell = 0;
  for (unsigned k = 0; k < farthest_tried && !some.empty(); ++k)
    topology::add_bond_shell(neighbours_of, reached, shell, first);
  return found;
}

// Rings that are not hexagons, and irregular chains of the boundary, where they are looked for.
class DefectList {
 public:
  DefectList(const TrivalentNetwork& network, std::vector<bool> looked_for)
      : looked_for_(std::move(looked_for)) {
    for (RingIndex r = 0; r < network.rings.size(); ++r) update(network, r);
  }
  void update(const TrivalentNetwork& network, RingIndex ring) {
    const TrivalentRing& r = network.rings[ring];
    const bool here = r.size != 0 && is_looked_for(r.atom);
    rings_.update(ring, here && !r.boundary && r.size != 6);
    chains_.update(ring, here && r.boundary && !is_regular(network, ring));
  }
  // The list after the network has been made compact.
  DefectList renumbered(const TrivalentNetwork& network, std::span<const AtomIndex> former) const {
    std::vector<bool> looked_for;
    for (const AtomIndex a : former) looked_for.push_back(is_looked_for(a));
    return DefectList(network, std::move(looked_for));
  }
  const std::vector<RingIndex>& rings() const { return rings_.list(); }
  const std::vector<RingIndex>& chains() const { return chains_.list(); }
  bool empty() const { return rings().empty() && chains().empty(); }
  // In rings: so many trials are worth making.
  double weight() const {
    return static_cast<double>(rings().size()) + chain_weight * static_cast<double>(chains().size());
  }
  // Which of the two a trial is at. Draws nothing where there is no choice.
  const std::vector<RingIndex>& drawn(RandomStream& random) const {
    if (chains().empty()) return rings();
    if (rings().empty()) return chains();
    return random.uniform() * weight() < static_cast<double>(rings().size()) ? rings() : chains();
  }

 private:
  // A chain costs less than a ring and is put right in fewer trials.
  static constexpr double chain_weight = 0.1;
  // Atoms that were added are where something is tried.
  bool is_looked_for(AtomIndex atom) const { return atom >= looked_for_.size() || looked_for_[atom]; }
  std::vector<bool> looked_for_;  // of atoms
  IndexList rings_, chains_;
};

// What one place of a batch has come to.
struct Attempt {
  std::size_t trials = 0;  // drawn, those known to be refused included
  bool made = false;
  std::uint64_t key = 0;
  double allowance = 0;
  Trial trial;
};

// Chains of the boundary differ by little in energy: as hot as rings they would all be irregular. Of k T.
constexpr double boundary_temperature = 0.3;

// Blocks with more energy under the tether than the best so far are not judged by anything else, eV an atom.
constexpr double hopeless = 0.012;

constexpr double least_cosine = 0.2;  // of the angle between an atom's normal and the surface's

class Annealer {
 public:
  Annealer(SwitchingState& state, const TetherSurface& surface, const BondSwitchingOptions& options)
      : state_(state),
        surface_(surface),
        options_(options),
        team_(std::clamp(options.threads, 1u, static_cast<unsigned>(batch))),
        workspaces_(team_.size()),
        defects_(state.network, atoms_around(state.network, options.around)) {
    target_ = options.target_atoms ? options.target_atoms : state.network.atoms.size();
    atoms_ = state.network.atoms.size();
    penalty_ =
        options.count_penalty >= 0 ? options.count_penalty : default_penalty(static_cast<double>(target_));
    state_.tether = options.tether;
    identity_.resize(atoms_);
    std::iota(identity_.begin(), identity_.end(), 0u);
    next_identity_ = static_cast<std::uint32_t>(atoms_);
    changed_.assign(atoms_, 0);
  }

  BondSwitchingResult run() {
    result_.energy_before = relax_state(state_, surface_, 200, 0.02) / static_cast<double>(atoms_);
    double best_score = judged_score(result_.energy_before * static_cast<double>(atoms_));
    SwitchingState best = state_;
    result_.energy = result_.energy_before;
    for (int block = 0; block < options_.blocks && !defects_.empty(); ++block) {
      const double progress = options_.blocks > 1 ? static_cast<double>(block) / (options_.blocks - 1) : 1;
      terms_.temperature = options_.hot * std::pow(options_.cold / options_.hot, progress);
      run_block(block);
      refused_.next_block();
      compact_state();
      const double energy = relax_state(state_, surface_, 150, 0.02);
      const double per_atom = energy / static_cast<double>(atoms_);
      tell(block, 1);
      if (const double judged = judged_score(energy); judged < best_score) {
        best_score = judged;
        best = state_;
        result_.energy = per_atom;
      }
    }
    state_ = std::move(best);
    result_.defects = DefectList(state_.network, atoms_around(state_.network, {})).rings().size();
    return result_;
  }

 private:
  // Comparable between atom counts: what bends and binds differently from graphene, at the price of a wrong
  // count.
  double score(double energy) const {
    return energy - static_cast<double>(atoms_) * rebo2::graphene_energy + penalty_ * above() * above();
  }
  // Of a block, by what was asked for.
  double judged_score(double energy) {
    const double tethered = score(energy);
    if (!options_.judged) return tethered;
    least_tethered_ = std::min(least_tethered_, tethered);
    if (tethered > least_tethered_ + hopeless * static_cast<double>(atoms_))
      return std::numeric_limits<double>::infinity();
    return score(options_.judged(state_));
  }
  double above() const { return static_cast<double>(atoms_) - static_cast<double>(target_); }

  void tell(int block, double share_of_block) const {
    if (options_.progress) options_.progress((block + share_of_block) / options_.blocks);
  }

  void run_block(int block) {
    const auto trials = static_cast<std::size_t>(std::ceil(options_.trials_per_defect * defects_.weight()));
    std::size_t since_relaxation = 0;
    const std::size_t relax_every = std::max<std::size_t>(40, atoms_ / 50);
    const std::size_t enough = result_.trials + trials;
    while (result_.trials < enough && !defects_.empty()) {
      run_batch();
      for (const Attempt& attempt : batch_) {
        result_.trials += attempt.trials;
        if (attempt.trial.accepted && !overlaps(attempt.trial)) {
          commit(attempt.trial);
          ++since_relaxation;
        } else if (attempt.made && !attempt.trial.accepted) {
          refused_.add(attempt.key, attempt.allowance, batch_number_);
        }
      }
      if (since_relaxation >= relax_every) {
        compact_state();
        relax_state(state_, surface_, 15, 0.02);
        since_relaxation = 0;
      }
      const std::size_t left = enough - std::min(enough, result_.trials);
      tell(block, 1.0 - static_cast<double>(left) / static_cast<double>(trials));
    }
  }

  void run_batch() {
    batch_.assign(batch, Attempt{});
    terms_.count_penalty = penalty_;
    terms_.climb_share = options_.climb_share;
    terms_.atoms_above_target = static_cast<long>(atoms_) - static_cast<long>(target_);
    const std::uint64_t first = next_stream_;
    next_stream_ += batch;
    team_.run(batch, [&](std::size_t k, unsigned thread) {
      RandomStream random(options_.seed, first + k);
      batch_[k] = attempt(random, workspaces_[thread]);
    });
    changed_.resize(state_.network.atoms.size(), 0);
    ++batch_number_;
  }

  // Most draws cost next to nothing: ring sizes rule them out, or the same switch has been refused before
  // under a higher allowance. Draws until one must be tried.
  Attempt attempt(RandomStream& random, TrialWorkspace& workspace) const {
    Attempt attempt;
    constexpr int draws = 60;
    for (int draw = 0; draw < draws && !attempt.made; ++draw) {
      const std::vector<RingIndex>& sites = defects_.drawn(random);
      auto edit = draw_edit(state_.network, sites, options_.climb_share, random, options_.largest_ring);
      if (!edit) continue;
      ++attempt.trials;
      TrialTerms terms = terms_;
      if (&sites == &defects_.chains()) terms.temperature *= boundary_temperature;
      attempt.allowance = draw_allowance(*edit, terms, random);
      attempt.key = switch_key(*edit, identity_);
      if (refused_.contains(attempt.key, attempt.allowance, last_change(*edit))) continue;
      attempt.made = true;
      attempt.trial = try_edit(state_, std::move(*edit), attempt.allowance, least_cosine, workspace);
    }
    attempt.trials = std::max<std::size_t>(attempt.trials, 1);
    return attempt;
  }

  // The batch that moved one of the switch's own atoms last: what happens farther away hardly matters.
  std::uint64_t last_change(const NetworkEdit& edit) const {
    std::uint64_t last = 0;
    for (const auto& change : edit.atoms)
      if (change.atom < changed_.size()) last = std::max(last, changed_[change.atom]);
    return last;
  }

  bool overlaps(const Trial& trial) const {
    return std::any_of(trial.looked.begin(), trial.looked.end(),
                       [&](AtomIndex a) { return a < changed_.size() && changed_[a] == batch_number_; });
  }

  void commit(const Trial& trial) {
    const CommittedEdit made = commit_edit(state_.network, *trial.edit, free_atoms_, free_rings_);
    state_.positions.resize(state_.network.atoms.size(), Vec3::Zero());
    state_.planes.resize(state_.network.atoms.size());
    const bool bounded = !state_.edges.empty();
    if (bounded) state_.edges.resize(state_.network.atoms.size(), {Vec3::Zero(), Vec3::Zero()});
    changed_.resize(state_.network.atoms.size(), 0);
    identity_.resize(state_.network.atoms.size());
    for (int k = 0; k < trial.edit->added; ++k)
      identity_[made.atoms[static_cast<std::size_t>(k)]] = next_identity_++;
    for (std::size_t k = 0; k < trial.moved.size(); ++k) {
      const AtomIndex a = made.entry(trial.moved[k]);
      state_.positions[a] = trial.positions[k];
      state_.planes[a] = trial.planes[k];
      if (bounded) state_.edges[a] = trial.edges[k];
      changed_[a] = batch_number_;
    }
    atoms_ = static_cast<std::size_t>(static_cast<long>(atoms_) + trial.edit->atoms_added());
    update_defects(*trial.edit, made);
    ++result_.accepted;
  }

  void update_defects(const NetworkEdit& edit, const CommittedEdit& made) {
    const TrivalentNetwork& network = state_.network;
    for (const bool added : {false, true})
      for (const auto& [ring, change] : edit.rings)
        if (is_added_ring(ring) == added) defects_.update(network, made.ring_entry(ring));
    // Whether a chain is regular depends on those beside it.
    for (const auto& change : edit.atoms) {
      if (!change.record.exists()) continue;
      for (const RingIndex ring : network.atoms[made.entry(change.atom)].ring) {
        if (!network.rings[ring].boundary) continue;
        const ChainPlace place = chain_place(network, ring);
        for (const RingIndex chain : {ring, place.before, place.after}) defects_.update(network, chain);
      }
    }
  }

  void compact_state() {
    if (free_atoms_.empty() && free_rings_.empty()) return;
    const std::vector<AtomIndex> former = compact(state_.network);
    for (std::size_t a = 0; a < former.size(); ++a) {
      state_.positions[a] = state_.positions[former[a]];
      state_.planes[a] = state_.planes[former[a]];
      if (!state_.edges.empty()) state_.edges[a] = state_.edges[former[a]];
      changed_[a] = changed_[former[a]];
      identity_[a] = identity_[former[a]];
    }
    state_.positions.resize(former.size());
    state_.planes.resize(former.size());
    if (!state_.edges.empty()) state_.edges.resize(former.size());
    free_atoms_.clear();
    free_rings_.clear();
    changed_.resize(former.size());
    identity_.resize(former.size());
    defects_ = defects_.renumbered(state_.network, former);
  }

  SwitchingState& state_;
  const TetherSurface& surface_;
  const BondSwitchingOptions& options_;
  ThreadTeam team_;
  std::vector<TrialWorkspace> workspaces_;
  DefectList defects_;
  std::vector<Attempt> batch_;
  RefusedSwitches refused_;
  std::vector<std::uint32_t> identity_;  // of each atom, whatever entry it has
  std::uint32_t next_identity_ = 0;
  std::vector<std::uint64_t> changed_;  // number of the last batch that moved the atom
  std::uint64_t batch_number_ = 0, next_stream_ = 0;
  std::vector<AtomIndex> free_atoms_;
  std::vector<RingIndex> free_rings_;
  TrialTerms terms_;
  std::size_t target_ = 0, atoms_ = 0;
  double penalty_ = 0;
  double least_tethered_ = std::numeric_limits<double>::infinity();  // score of a block
  BondSwitchingResult result_;
};

}  // namespace

double relax_state(SwitchingState& state, const TetherSurface& surface, int max_iterations,
                   double force_tolerance) {
  FixedBondModel model;
  model.rebo2.set_graph(fixed_bond_graph(state.network, state.space));
  model.tether = state.tether;
  model.free_mean = state.free_mean;
  model.running = state.running;
  if (state.planes.size() != state.positions.size()) state.planes = tangent_planes(surface, state.positions);
  model.planes = std::move(state.planes);
  const minimisation::LbfgsResult relaxed =
      minimise_fixed_bonds(model, &surface, state.positions,
                           {.max_iterations = max_iterations, .force_tolerance = force_tolerance});
  state.planes = std::move(model.planes);
  state.edges = std::move(model.edges);
  state.reach = model.reach;
  state.mean_height = state.free_mean ? mean_height(state.planes, state.positions) : 0;
  state.contacts = std::move(model.contacts);
  state.contacts.renew(state.positions, model.rebo2.graph());
  return relaxed.energy;
}

BondSwitchingResult anneal_bonds(SwitchingState& state, const TetherSurface& surface,
                                 const BondSwitchingOptions& options) {
  const auto stage = state.running.stage("switching");
  return Annealer(state, surface, options).run();
}

}  // namespace nanocarbon::annealing
