// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/bond_watch.h"

#include <algorithm>

namespace nanocarbon::airebo {

using potential::AtomsView;
using potential::NearPairs;

namespace {

double squared_distance(const double* positions, std::uint32_t i, std::uint32_t j) {
  const double* a = positions + 3 * std::size_t{i};
  const double* b = positions + 3 * std::size_t{j};
  const double x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2];
  return x * x + y * y + z * z;
}

}  // namespace

void BondWatch::prepare(const AtomsView& atoms, const NearPairs& near, const NearPairs& whole_bonds,
                        const std::vector<char>& watched, const AireboParameters& parameters, double margin) {
  whole_.clear();
  separate_.clear();
  flags_.assign(atoms.all, 0);
  disturbed_.clear();
  const auto share_their_only_bond = [&](std::uint32_t i, std::uint32_t j) {
    const auto of_i = whole_bonds.of(i), of_j = whole_bonds.of(j);
    return of_i.size() == 1 && of_j.size() == 1 && of_i[0] == of_j[0];
  };
  for (std::uint32_t i = 0; i < atoms.all; ++i) {
    if (!watched[i]) continue;
    const auto bonds = whole_bonds.of(i);
    for (const std::uint32_t j : near.of(i)) {
      if (watched[j] && j < i) continue;  // comes by in the other row
      const std::size_t pair = rebo2::pair_index(atoms.elements[i], atoms.elements[j]);
      const rebo2::PairParameters& p = parameters.rebo.pairs[pair];
      if (std::find(bonds.begin(), bonds.end(), j) != bonds.end()) {
        whole_.push_back({i, j, p.cutoff_begin * p.cutoff_begin});
        continue;
      }
      const double range = p.cutoff_end + margin;
      if (!(squared_distance(atoms.positions, i, j) < range * range)) continue;
      if (atoms.elements[i] == Element::hydrogen && atoms.elements[j] == Element::hydrogen &&
          share_their_only_bond(i, j))
        continue;
      separate_.push_back({i, j, p.cutoff_end * p.cutoff_end});
    }
    // A bond that has become so long that its ends are not near any more.
    for (const std::uint32_t j : bonds) {
      const auto row = near.of(i);
      if (std::find(row.begin(), row.end(), j) == row.end()) whole_.push_back({i, j, 0.0});
    }
  }
}

void BondWatch::flag(const Pair& pair) {
  for (const std::uint32_t atom : {pair.i, pair.j}) {
    if (flags_[atom]) continue;
    flags_[atom] = 1;
    disturbed_.push_back(atom);
  }
}

const std::vector<std::uint32_t>& BondWatch::find(const double* positions) {
  for (const std::uint32_t atom : disturbed_) flags_[atom] = 0;
  disturbed_.clear();
  for (const Pair& pair : whole_)
    if (!(squared_distance(positions, pair.i, pair.j) < pair.squared_limit)) [[unlikely]]
      flag(pair);
  for (const Pair& pair : separate_)
    if (squared_distance(positions, pair.i, pair.j) < pair.squared_limit) [[unlikely]]
      flag(pair);
  return disturbed_;
}

}  // namespace nanocarbon::airebo
