// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/exclusions.h"

#include <algorithm>

#include "nanocarbon/core/vec3.h"

namespace nanocarbon::airebo {

using potential::AtomsView;
using potential::NearPairs;

namespace {

void close_row(NearPairs& rows) { rows.offsets.push_back(static_cast<std::uint32_t>(rows.atoms.size())); }

}  // namespace

NearPairs find_whole_bonds(const AtomsView& atoms, const NearPairs& near,
                           const AireboParameters& parameters) {
  NearPairs bonds;
  for (std::uint32_t i = 0; i < atoms.all; ++i) {
    const Eigen::Map<const Vec3> from(atoms.positions + 3 * std::size_t{i});
    for (const std::uint32_t j : near.of(i)) {
      const Eigen::Map<const Vec3> to(atoms.positions + 3 * std::size_t{j});
      const std::size_t pair = rebo2::pair_index(atoms.elements[i], atoms.elements[j]);
      const double whole = parameters.rebo.pairs[pair].cutoff_begin;
      if ((to - from).squaredNorm() < whole * whole) bonds.atoms.push_back(j);
    }
    close_row(bonds);
  }
  return bonds;
}

NearPairs find_exclusions(std::uint32_t own, const NearPairs& whole_bonds) {
  NearPairs excluded;
  std::vector<std::uint32_t> row;
  for (std::uint32_t i = 0; i < own; ++i) {
    row.clear();
    const auto add = [&](std::uint32_t j) {
      if (j > i) row.push_back(j);  // copies have larger numbers than own atoms
    };
    for (const std::uint32_t a : whole_bonds.of(i)) {
      add(a);
      for (const std::uint32_t b : whole_bonds.of(a)) {
        if (b == i) continue;
        add(b);
        for (const std::uint32_t c : whole_bonds.of(b)) add(c);
      }
    }
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    excluded.atoms.insert(excluded.atoms.end(), row.begin(), row.end());
    close_row(excluded);
  }
  return excluded;
}

bool is_excluded(const NearPairs& exclusions, std::uint32_t own, std::uint32_t i, std::uint32_t j) {
  if (j < own && j < i) std::swap(i, j);
  // Rows are short, and steps of a binary search are hard to guess for a processor.
  bool found = false;
  for (const std::uint32_t excluded : exclusions.of(i)) found |= excluded == j;
  return found;
}

}  // namespace nanocarbon::airebo
