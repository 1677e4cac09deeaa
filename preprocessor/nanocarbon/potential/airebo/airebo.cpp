// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/airebo.h"

#include <algorithm>
#include <optional>

#include "nanocarbon/potential/airebo/arrangement.h"
#include "nanocarbon/potential/airebo/fast_evaluation.h"
#include "nanocarbon/potential/airebo/general_evaluation.h"
#include "nanocarbon/potential/airebo/lj/lj_sum.h"

namespace nanocarbon::airebo {

using potential::AtomShares;
using potential::Virial;

namespace {

constexpr double skin = 0.4;  // of near pairs, and of all pairs of the general evaluation, Angstrom

}  // namespace

struct Airebo::State {
  State(const AireboParameters& parameters, const AireboTerms& terms, std::string_view instructions)
      : model(parameters, terms),
        cutoffs{cutoff(Element::carbon, Element::carbon), cutoff(Element::carbon, Element::hydrogen),
                cutoff(Element::hydrogen, Element::hydrogen)},
        general_lists(skin),
        fast_lists(skin),
        fast(model),
        plain(model.lj, options(instructions)) {}

  static LjSumOptions options(std::string_view instructions) {
    LjSumOptions options;
    options.instructions = instructions;
    return options;
  }

  BondCutoff cutoff(Element a, Element b) const {
    const rebo2::PairParameters& pair = model.parameters.rebo.pairs[rebo2::pair_index(a, b)];
    return {pair.cutoff_begin, pair.cutoff_end};
  }

  AireboModel model;
  BondCutoffs cutoffs;
  AireboResult result;
  std::vector<Virial> virials;
  std::size_t list_builds = 0;

  Arrangement general_lists;
  AireboWorkspace workspace;

  Arrangement fast_lists;
  FastEvaluation fast;
  LjSum plain;

  void evaluate_in_general(std::span<const Vec3> positions, std::span<const Element> elements,
                           const Cell* cell, const potential::EvaluationOptions& options);
  void evaluate_fast(std::span<const Vec3> positions, std::span<const Element> elements, const Cell* cell);
  void make_fast_lists(std::span<const Vec3> positions, std::span<const Element> elements, const Cell* cell);

  void start_result(const Arrangement& lists, const potential::EvaluationOptions& options) {
    const std::size_t all = lists.sites().all();
    result.forces.assign(all, Vec3::Zero());
    result.atom_energies.assign(options.atom_energies ? all : 0, 0.0);
    virials.assign(options.atom_virials ? all : 0, Virial{});
  }
  double* forces() { return result.forces.empty() ? nullptr : result.forces.front().data(); }

  //! Sums the virial, and gives the copies' forces and shares to the atoms that they are copies of.
  void finish_result(const Arrangement& lists);
};

void Airebo::State::finish_result(const Arrangement& lists) {
  const Sites& sites = lists.sites();
  const double* coordinates = lists.view().positions;
  result.virial.setZero();
  for (std::size_t a = 0; a < result.forces.size(); ++a)
    result.virial += Eigen::Map<const Vec3>(coordinates + 3 * a) * result.forces[a].transpose();
  for (std::size_t site = sites.own; site < sites.all(); ++site) {
    const std::size_t to = sites.sites[site].of;
    result.forces[to] += result.forces[site];
    if (!result.atom_energies.empty()) result.atom_energies[to] += result.atom_energies[site];
    if (!virials.empty())
      for (int d = 0; d < 6; ++d) virials[to][d] += virials[site][d];
  }
  result.forces.resize(sites.own);
  if (!result.atom_energies.empty()) result.atom_energies.resize(sites.own);
  result.atom_virials.clear();
  for (std::size_t i = 0; i < std::min<std::size_t>(sites.own, virials.size()); ++i) {
    const Virial& v = virials[i];
    Mat3& m = result.atom_virials.emplace_back();
    m << v[0], v[3], v[4], v[3], v[1], v[5], v[4], v[5], v[2];
  }
}

void Airebo::State::evaluate_in_general(std::span<const Vec3> positions, std::span<const Element> elements,
                                        const Cell* cell, const potential::EvaluationOptions& options) {
  Arrangement& lists = general_lists;
  if (lists.is_of(elements, cell) && lists.near_is_good(positions)) {
    lists.place(positions, cell);
  } else {
    const double pair_reach = long_range_reach(model);
    lists.make(positions, elements, cell, std::max(pair_reach, bond_reach(model.parameters)) + skin,
               longest_bond(model.parameters), pair_reach + skin);
    ++list_builds;
  }
  start_result(lists, options);
  AtomShares shares;
  if (options.atom_energies) shares.energies = result.atom_energies.data();
  if (options.atom_virials) shares.virials = virials.data();
  result.energy_parts =
      evaluate_general(lists.view(), lists.near(), lists.pairs(), model, workspace, forces(), shares);
  finish_result(lists);
}

void Airebo::State::make_fast_lists(std::span<const Vec3> positions, std::span<const Element> elements,
                                    const Cell* cell) {
  const double margin = LjOwnListOptions().margin;
  fast_lists.make(positions, elements, cell, bond_reach(model.parameters) + margin,
                  longest_bond(model.parameters), longest_hypothetical_bond(model.parameters) + margin);
  fast.lists_changed(fast_lists.view(), fast_lists.near(), fast_lists.pairs(), skin);
  if (model.terms.long_range)
    plain.find_pairs(positions, elements, cell, fast_lists.as_neighbours(fast.exclusions()));
  ++list_builds;
}

void Airebo::State::evaluate_fast(std::span<const Vec3> positions, std::span<const Element> elements,
                                  const Cell* cell) {
  const double* given = positions.empty() ? nullptr : positions.front().data();
  const bool plain_sum = model.terms.long_range && !positions.empty();
  if (!fast_lists.is_of(elements, cell) || (plain_sum && !plain.place(given, cell))) {
    make_fast_lists(positions, elements, cell);
    if (plain_sum) plain.place(given, cell);
  } else {
    fast_lists.place(positions, cell);
    if (!fast_lists.near_is_good(positions)) {
      fast_lists.find_near(positions);
      fast.near_changed(fast_lists.view(), fast_lists.near());
    }
  }
  start_result(fast_lists, {});
  result.energy_parts = fast.evaluate(fast_lists.view(), fast_lists.near(), forces());
  finish_result(fast_lists);
  if (!plain_sum) return;
  const LjResult sum = plain.evaluate(forces());
  result.energy_parts.long_range += sum.energy;
  result.virial += sum.virial;
}

Airebo::Airebo(const AireboParameters& parameters, const AireboTerms& terms, std::string_view instructions)
    : state_(std::make_unique<State>(parameters, terms, instructions)) {}
Airebo::~Airebo() = default;
Airebo::Airebo(Airebo&&) noexcept = default;
Airebo& Airebo::operator=(Airebo&&) noexcept = default;

const AireboResult& Airebo::evaluate(std::span<const Vec3> positions, std::span<const Element> elements,
                                     const Cell* cell, const potential::EvaluationOptions& options) {
  State& s = *state_;
  if (options.general_only || options.atom_energies || options.atom_virials)
    s.evaluate_in_general(positions, elements, cell, options);
  else
    s.evaluate_fast(positions, elements, cell);
  s.result.energy = s.result.energy_parts.total();
  return s.result;
}

std::string_view Airebo::name() const {
  return state_->model.parameters.form == LjForm::morse ? "airebo-m" : "airebo";
}

std::vector<potential::EnergyPart> Airebo::parts() const {
  const AireboEnergyParts& p = state_->result.energy_parts;
  const bool morse = state_->model.parameters.form == LjForm::morse;
  return {{"rebo", p.rebo()}, {morse ? "morse" : "lennard_jones", p.long_range}, {"torsion", p.torsion()}};
}

const BondCutoffs& Airebo::bond_cutoffs() const { return state_->cutoffs; }
double Airebo::graphene_energy() const { return state_->model.parameters.graphene_energy; }

double Airebo::hydrogen_energy() const {
  const AireboParameters& parameters = state_->model.parameters;
  return parameters.benzene_energy / 6 - parameters.graphene_energy;
}
double Airebo::unbonded_reach() const { return long_range_reach(state_->model); }

std::size_t Airebo::general_atoms() const { return state_->fast.general_atoms(); }
std::size_t Airebo::single_terms() const { return state_->fast.single_terms(); }
std::size_t Airebo::list_builds() const { return state_->list_builds; }

}  // namespace nanocarbon::airebo
