// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/fixed_bond_loops.h"

#include <algorithm>

#include "nanocarbon/potential/rebo2/coordination_tables.h"
#include "nanocarbon/potential/rebo2/parameters.h"
#include "nanocarbon/potential/rebo2/sp2_constants.h"
#include "nanocarbon/potential/rebo2/kernels/sp2_dispatch.h"

namespace nanocarbon::annealing {

namespace {

constexpr std::uint32_t nowhere = static_cast<std::uint32_t>(-1);

// Bonds of intermediate molecules; the polynomials are good to 1e-10 eV there. Angstrom.
constexpr double shortest = 1.1, longest = 2.0;
// Nearly straight and nearly folded angles have no direction for a dihedral.
constexpr double largest_cosine = 0.998;

rebo2::Sp2Constants wide_constants() {
  rebo2::Sp2Constants c = rebo2::make_sp2_constants(rebo2::rebo2_parameters(), shortest, longest);
  c.lowest_cosine = -largest_cosine;
  c.highest_cosine = largest_cosine;
  return c;
}

double torsion_constant() {
  static const double constant = rebo2::sp2_bond_constants(rebo2::rebo2_tables()).torsion;
  return constant;
}

rebo2::Sp2Modifiers make_plain_modifiers() {
  rebo2::Sp2Modifiers m = {};
  std::fill_n(m.on, rebo2::sp2_block, 1.0);
  for (auto& torsion : m.torsion) std::fill_n(torsion, rebo2::sp2_block, torsion_constant());
  return m;
}

}  // namespace

void FixedBondLoops::set_graph(const FixedBondGraph& graph) {
  place_.assign(graph.neighbours.size(), nowhere);
  atoms_.clear();
  for (AtomIndex a = 0; a < graph.inner_count(); ++a)
    if (graph.complete(a)) {
      place_[a] = static_cast<std::uint32_t>(atoms_.size());
      atoms_.push_back(a);
    }
  const std::size_t fast = atoms_.size();
  blocks_ = (fast + rebo2::sp2_block - 1) / rebo2::sp2_block;
  // Padding repeats the first atom of its block.
  if (blocks_ > 0) atoms_.resize(blocks_ * rebo2::sp2_block, atoms_[(blocks_ - 1) * rebo2::sp2_block]);
  slots_.resize(blocks_);
  for (std::uint32_t block = 0; block < blocks_; ++block) slots_[block] = block;
  outside_.assign(blocks_, 0);
  lay_out_bonds(graph);
  set_modifiers(graph, fast);
  geometry_.resize(blocks_ * 12 * rebo2::sp2_block);
  tensors_.assign(blocks_ * 18 * rebo2::sp2_block + 6, 0);
  forces_.resize(3 * graph.neighbours.size());
  space_ = graph.space;
  copies_known_ = !space_.periodic();
  copies_.clear();
}

void FixedBondLoops::lay_out_bonds(const FixedBondGraph& graph) {
  const auto zero_record = static_cast<std::uint32_t>(3 * rebo2::sp2_block * blocks_);
  neighbours_.resize(3 * atoms_.size());
  reverses_.resize(3 * atoms_.size());
  for (std::size_t at = 0; at < atoms_.size(); ++at)
    for (std::uint32_t s = 0; s < 3; ++s) {
      const std::size_t index = (at / rebo2::sp2_block * 3 + s) * rebo2::sp2_block + at % rebo2::sp2_block;
      const AtomIndex n = graph.neighbours[atoms_[at]][s];
      neighbours_[index] = n;
      reverses_[index] = place_[n] == nowhere ? zero_record : 3 * place_[n] + graph.slot(n, atoms_[at]);
    }
}

void FixedBondLoops::set_modifiers(const FixedBondGraph& graph, std::size_t fast) {
  static const rebo2::Sp2Modifiers plain = make_plain_modifiers();
  special_.clear();
  auto& which = special_of_block_;
  which.assign(blocks_, 0);
  const auto special = [&](std::size_t at) -> rebo2::Sp2Modifiers& {
    std::size_t& k = which[at / rebo2::sp2_block];
    if (k == 0) {
      special_.push_back(plain);
      k = special_.size();
    }
    return special_[k - 1];
  };
  for (std::size_t at = 0; at < atoms_.size(); ++at) {
    if (at >= fast) special(at).on[at % rebo2::sp2_block] = 0;
    for (std::uint32_t s = 0; s < 3; ++s)
      if (place_[graph.neighbours[atoms_[at]][s]] == nowhere)
        special(at).torsion[s][at % rebo2::sp2_block] = 0;
  }
  modifiers_.resize(blocks_);
  for (std::size_t block = 0; block < blocks_; ++block)
    modifiers_[block] = which[block] ? &special_[which[block] - 1] : &plain;
}

void FixedBondLoops::find_copies(std::span<const Vec3> positions) {
  for (std::size_t at = 0; at < atoms_.size(); ++at)
    for (std::uint32_t s = 0; s < 3; ++s) {
      std::uint32_t& n =
          neighbours_[(at / rebo2::sp2_block * 3 + s) * rebo2::sp2_block + at % rebo2::sp2_block];
      const std::array<std::int32_t, 3> image = space_.image(positions[atoms_[at]], positions[n]);
      if (image == std::array<std::int32_t, 3>{0, 0, 0}) continue;
      copies_.push_back({n, image_shift(*space_.cell(), image)});
      n = static_cast<std::uint32_t>(positions.size() + copies_.size() - 1);
    }
  forces_.resize(3 * (positions.size() + copies_.size()));
  copies_known_ = true;
}

std::optional<double> FixedBondLoops::evaluate(std::span<const Vec3> positions, std::span<Vec3> gradient) {
  if (blocks_ == 0) return 0.0;
  if (!copies_known_) find_copies(positions);
  const Vec3* places = positions.data();
  if (!copies_.empty()) {
    with_copies_.assign(positions.begin(), positions.end());
    for (const Copy& copy : copies_) with_copies_.push_back(positions[copy.of] + copy.shift);
    places = with_copies_.data();
  }
  static const rebo2::Sp2Constants constants = wide_constants();
  static const rebo2::Sp2Loops& loops = rebo2::usable_sp2_kernels().front()->bond_order;
  std::fill(forces_.begin(), forces_.end(), 0.0);
  const rebo2::Sp2Data data = {&constants,       places->data(),    atoms_.data(),    neighbours_.data(),
                               reverses_.data(), slots_.data(),     geometry_.data(), tensors_.data(),
                               outside_.data(),  modifiers_.data(), forces_.data(),   nullptr};
  loops.first(data, 0, blocks_);
  if (std::any_of(outside_.begin(), outside_.end(), [](std::uint32_t bits) { return bits != 0; })) return {};
  rebo2::Sp2Energy energy = {};
  loops.second(data, 0, blocks_, &energy);
  for (std::size_t a = 0; a < gradient.size(); ++a)
    for (int d = 0; d < 3; ++d) gradient[a][d] -= forces_[3 * a + static_cast<std::size_t>(d)];
  for (std::size_t c = 0; c < copies_.size(); ++c)
    for (int d = 0; d < 3; ++d)
      gradient[copies_[c].of][d] -= forces_[3 * (gradient.size() + c) + static_cast<std::size_t>(d)];
  return energy.repulsive + energy.sigma_pi + energy.conjugation + energy.dihedral;
}

}  // namespace nanocarbon::annealing
