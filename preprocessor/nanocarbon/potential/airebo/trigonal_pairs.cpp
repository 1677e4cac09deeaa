// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/trigonal_pairs.h"

#include <algorithm>
#include <cmath>

#include "nanocarbon/potential/airebo/trigonal_term.h"

namespace nanocarbon::airebo {

using potential::AtomsView;
using potential::NearPairs;

namespace {

constexpr std::size_t at_a_time = 64;

}  // namespace

TrigonalPairs::TrigonalPairs(const AireboModel& model)
    : model_(model),
      plain_(trigonal_order_is_plain(model.parameters.rebo)),
      bound_(model.parameters.rebo.carbon) {}

void TrigonalPairs::clear(std::size_t atoms) {
  pairs_.clear();
  carbons_.clear();
  numbers_.assign(atoms, unknown);
}

std::uint32_t TrigonalPairs::carbon_of(std::uint32_t atom, const AtomsView& atoms,
                                       const NearPairs& whole_bonds) {
  std::uint32_t& number = numbers_[atom];
  if (number != unknown) return number;
  const auto bonds = whole_bonds.of(atom);
  if (!plain_ || atoms.elements[atom] != Element::carbon || bonds.size() != 3) return number = other;
  TrigonalCarbon carbon = {};
  carbon.atom = atom;
  std::copy(bonds.begin(), bonds.end(), carbon.neighbours.begin());
  const auto carbons = static_cast<double>(std::count_if(
      bonds.begin(), bonds.end(), [&](std::uint32_t n) { return atoms.elements[n] == Element::carbon; }));
  carbon.base = 1.0 + model_.parameters.rebo.tables.p_cc.evaluate(carbons, 3.0 - carbons).value;
  carbons_.push_back(carbon);
  return number = static_cast<std::uint32_t>(carbons_.size() - 1);
}

bool TrigonalPairs::add(std::uint32_t i, std::uint32_t j, const AtomsView& atoms,
                        const NearPairs& whole_bonds) {
  const std::uint32_t carbon_i = carbon_of(i, atoms, whole_bonds),
                      carbon_j = carbon_of(j, atoms, whole_bonds);
  if (carbon_i == other || carbon_j == other) return false;
  pairs_.push_back({i, j, carbon_i, carbon_j});
  return true;
}

void TrigonalPairs::place(TrigonalCarbon& carbon, const AtomsView& atoms) const {
  const double* from = atoms.positions + 3 * std::size_t{carbon.atom};
  for (int b = 0; b < 3; ++b) {
    const double* to = atoms.positions + 3 * std::size_t{carbon.neighbours[b]};
    const double x = to[0] - from[0], y = to[1] - from[1], z = to[2] - from[2];
    const double inverse = 1.0 / std::sqrt(x * x + y * y + z * z);
    carbon.along[3 * b] = x * inverse;
    carbon.along[3 * b + 1] = y * inverse;
    carbon.along[3 * b + 2] = z * inverse;
    carbon.inverse[b] = inverse;
  }
  carbon.step = step_;
}

double TrigonalPairs::evaluate(const AtomsView& atoms, const BondWatch& watch, double* forces,
                               std::vector<std::array<std::uint32_t, 2>>& left) {
  ++step_;
  const LongRangeParameters& parameters = model_.parameters.long_range[0];
  const double end = std::min(parameters.length_switch_end, lj_reach(model_.lj, 0));
  double energy = 0.0;
  std::array<TrigonalPair, at_a_time> block;
  std::array<double, at_a_time> lengths;
  std::size_t count = 0;
  const auto finish_block = [&] {
    high_.clear();
    bound_.find_high({block.data(), count}, parameters.order_switch_begin, high_);
    for (const std::uint32_t n : high_)
      energy += add_trigonal_term(*block[n].i, *block[n].j, block[n].along, lengths[n], model_, forces);
    count = 0;
  };
  for (const Pair& pair : pairs_) {
    const double* a = atoms.positions + 3 * std::size_t{pair.i};
    const double* b = atoms.positions + 3 * std::size_t{pair.j};
    const double x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2];
    const double squared = x * x + y * y + z * z;
    if (!(squared < end * end)) continue;
    if (watch.is_disturbed(pair.i) || watch.is_disturbed(pair.j)) [[unlikely]] {
      left.push_back({pair.i, pair.j});
      continue;
    }
    TrigonalCarbon &i = carbons_[pair.carbon_i], &j = carbons_[pair.carbon_j];
    if (i.step != step_) place(i, atoms);
    if (j.step != step_) place(j, atoms);
    const double length = std::sqrt(squared), inverse = 1.0 / length;
    block[count] = {&i, &j, {x * inverse, y * inverse, z * inverse}};
    lengths[count] = length;
    if (++count == at_a_time) finish_block();
  }
  finish_block();
  return energy;
}

std::size_t TrigonalPairs::memory() const {
  return sizeof(std::uint32_t) * numbers_.capacity() + sizeof(TrigonalCarbon) * carbons_.capacity() +
         sizeof(Pair) * pairs_.capacity();
}

}  // namespace nanocarbon::airebo
