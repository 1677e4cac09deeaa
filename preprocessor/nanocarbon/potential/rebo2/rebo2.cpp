// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/rebo2.h"

#include <algorithm>
#include <optional>

#include "nanocarbon/core/approach_watch.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/potential/periodic_copies.h"
#include "nanocarbon/potential/rebo2/kernels/sp2_dispatch.h"
#include "nanocarbon/potential/rebo2/mixed_evaluation.h"

namespace nanocarbon::rebo2 {

namespace {

constexpr double skin = 0.4;  // Angstrom
// Fewer atoms are listed anew about as soon as parts that move as a whole are told apart.
constexpr std::size_t least_for_parts = 2000;

double largest_cutoff(const Rebo2Parameters& parameters) {
  double largest = 0.0;
  for (const PairParameters& pair : parameters.pairs) largest = std::max(largest, pair.cutoff_end);
  return largest;
}

bool same_cell(const std::optional<Cell>& a, const Cell* b) {
  if (!a || !b) return !a && !b;
  return a->vectors == b->vectors && a->periodic == b->periodic;
}

const Sp2Kernel& find_kernel(std::string_view name) {
  if (name.empty()) return *usable_sp2_kernels().front();
  std::string known;
  for (const Sp2Kernel* kernel : usable_sp2_kernels()) {
    if (name == kernel->name) return *kernel;
    known.append(" ").append(kernel->name);
  }
  throw UserError(Failure::usage,
                  "no fast evaluation for instructions '" + std::string(name) + "' here; there are:" + known);
}

}  // namespace

struct Rebo2::State {
  State(const Rebo2Parameters& p, std::string_view instructions)
      : parameters(p),
        cutoffs{cutoff(Element::carbon, Element::carbon), cutoff(Element::carbon, Element::hydrogen),
                cutoff(Element::hydrogen, Element::hydrogen)},
        evaluation(p, find_kernel(instructions)),
        watch(largest_cutoff(p), skin) {}

  BondCutoff cutoff(Element a, Element b) const {
    const PairParameters& pair = parameters.pairs[pair_index(a, b)];
    return {pair.cutoff_begin, pair.cutoff_end};
  }

  Rebo2Parameters parameters;
  BondCutoffs cutoffs;
  MixedEvaluation evaluation;
  Rebo2Result result;

  potential::NearAtoms near;
  ApproachWatch watch;            // of the positions that were listed
  std::vector<Element> elements;  // own atoms and copies
  std::optional<Cell> listed_cell;
  std::size_t list_builds = 0;

  std::vector<double> coordinates;  // of own atoms and copies, where there are copies
  std::vector<potential::Virial> virials;

  bool list_is_good(std::span<const Vec3> positions, std::span<const Element> own, const Cell* cell) {
    if (list_builds == 0 || positions.size() != watch.atoms() || !same_cell(listed_cell, cell)) return false;
    if (!std::equal(own.begin(), own.end(), elements.begin())) return false;
    return !watch.may_be_closer(positions, !cell && positions.size() >= least_for_parts);
  }

  void make_list(std::span<const Vec3> positions, std::span<const Element> own, const Cell* cell) {
    near = potential::find_near_atoms(positions, cell, largest_cutoff(parameters) + skin);
    watch.set(positions);
    elements.assign(own.begin(), own.end());
    for (const potential::PeriodicCopy& copy : near.copies) elements.push_back(own[copy.of]);
    listed_cell = cell ? std::optional<Cell>(*cell) : std::nullopt;
    ++list_builds;
    evaluation.near_changed();
  }

  //! Gives the copies' forces and shares to the atoms that they are copies of.
  void fold_copies();
  void take_virials(const double* positions);
  void take_atom_virials();
};

void Rebo2::State::fold_copies() {
  for (std::size_t c = 0; c < near.copies.size(); ++c) {
    const std::size_t from = near.own + c;
    const std::size_t to = near.copies[c].of;
    result.forces[to] += result.forces[from];
    if (!result.atom_energies.empty()) result.atom_energies[to] += result.atom_energies[from];
    if (!virials.empty())
      for (int d = 0; d < 6; ++d) virials[to][d] += virials[from][d];
  }
  result.forces.resize(near.own);
  if (!result.atom_energies.empty()) result.atom_energies.resize(near.own);
}

void Rebo2::State::take_virials(const double* positions) {
  result.virial.setZero();
  for (std::size_t a = 0; a < result.forces.size(); ++a)
    result.virial += Eigen::Map<const Vec3>(positions + 3 * a) * result.forces[a].transpose();
}

void Rebo2::State::take_atom_virials() {
  result.atom_virials.clear();
  if (virials.empty()) return;
  for (std::size_t i = 0; i < near.own; ++i) {
    const potential::Virial& v = virials[i];
    Mat3& m = result.atom_virials.emplace_back();
    m << v[0], v[3], v[4], v[3], v[1], v[5], v[4], v[5], v[2];
  }
}

Rebo2::Rebo2(const Rebo2Parameters& parameters, std::string_view instructions)
    : state_(std::make_unique<State>(parameters, instructions)) {}
Rebo2::~Rebo2() = default;
Rebo2::Rebo2(Rebo2&&) noexcept = default;
Rebo2& Rebo2::operator=(Rebo2&&) noexcept = default;

const Rebo2Result& Rebo2::evaluate(std::span<const Vec3> positions, std::span<const Element> elements,
                                   const Cell* cell, const potential::EvaluationOptions& options) {
  State& s = *state_;
  if (!s.list_is_good(positions, elements, cell)) s.make_list(positions, elements, cell);
  const std::size_t all = s.elements.size();
  const double* coordinates = positions.empty() ? nullptr : positions.front().data();
  if (!s.near.copies.empty()) {
    potential::place_atoms(positions, cell, s.near, s.coordinates);
    coordinates = s.coordinates.data();
  }
  s.result.forces.assign(all, Vec3::Zero());
  s.result.atom_energies.assign(options.atom_energies ? all : 0, 0.0);
  s.virials.assign(options.atom_virials ? all : 0, potential::Virial{});
  potential::AtomShares shares;
  if (options.atom_energies) shares.energies = s.result.atom_energies.data();
  if (options.atom_virials) shares.virials = s.virials.data();
  const potential::AtomsView atoms = {coordinates, s.elements.data(), s.near.own,
                                      static_cast<std::uint32_t>(all)};
  double* forces = all > 0 ? s.result.forces.front().data() : nullptr;
  s.result.parts = s.evaluation.evaluate(atoms, s.near.pairs, forces, shares, options.general_only);
  s.result.energy = s.result.parts.total();
  s.take_virials(coordinates);
  s.fold_copies();
  s.take_atom_virials();
  return s.result;
}

std::vector<potential::EnergyPart> Rebo2::parts() const {
  const EnergyParts& p = state_->result.parts;
  return {{"repulsive", p.repulsive},
          {"sigma_pi", p.sigma_pi},
          {"conjugation", p.conjugation},
          {"dihedral", p.dihedral}};
}

const BondCutoffs& Rebo2::bond_cutoffs() const { return state_->cutoffs; }

std::size_t Rebo2::general_atoms() const { return state_->evaluation.general_atoms(); }
std::size_t Rebo2::list_builds() const { return state_->list_builds; }

}  // namespace nanocarbon::rebo2
