// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/analysis/distributions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nanocarbon::analysis {

Histogram histogram(std::span<const double> values, double width) {
  Histogram result{0.0, width, {}};
  if (values.empty()) return result;
  constexpr double rounding = 1e-9;  // a value on the border of two bins belongs to the upper one
  const auto bin = [&](double value) { return std::floor(value / width + rounding); };
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double first = bin(*low);
  result.from = first * width;
  result.counts.assign(static_cast<std::size_t>(bin(*high) - first) + 1, 0);
  for (const double value : values) ++result.counts[static_cast<std::size_t>(bin(value) - first)];
  return result;
}

Distribution distribution(std::span<const double> values, double bin_width) {
  std::vector<double> finite;
  finite.reserve(values.size());
  for (const double value : values)
    if (std::isfinite(value)) finite.push_back(value);
  return {molecule::spread(finite), histogram(finite, bin_width)};
}

BondDistributions bond_distributions(const Molecule& molecule, const BondRows& rows) {
  constexpr double length_bin = 0.01, angle_bin = 1.0;
  BondDistributions result;
  std::array<std::vector<double>, 3> lengths;
  std::vector<double> angles;
  std::vector<Vec3> units;
  for (AtomIndex a = 0; a < molecule.size(); ++a) {
    const bool carbon = molecule.elements[a] == Element::carbon;
    ++(carbon ? result.carbons : result.hydrogens);
    const auto ends = rows.of(a);
    if (carbon) {
      if (result.carbons_with.size() <= ends.size()) result.carbons_with.resize(ends.size() + 1, 0);
      ++result.carbons_with[ends.size()];
    }
    units.clear();
    for (const BondRowEnd& end : ends) {
      const Vec3 vector = bond_vector(molecule, a, end);
      const double length = vector.norm();
      units.push_back(vector / length);
      const bool other_carbon = molecule.elements[end.atom] == Element::carbon;
      lengths[static_cast<std::size_t>(!carbon) + static_cast<std::size_t>(!other_carbon)].push_back(length);
    }
    if (!carbon) continue;
    for (std::size_t i = 0; i < units.size(); ++i)
      for (std::size_t j = i + 1; j < units.size(); ++j)
        angles.push_back(std::acos(std::clamp(units[i].dot(units[j]), -1.0, 1.0)) * 180.0 / std::numbers::pi);
  }
  const auto of_bonds = [&](std::vector<double>& values) {  // each bond was met at both ends
    Distribution d = distribution(values, length_bin);
    d.spread.count /= 2;
    for (std::size_t& count : d.histogram.counts) count /= 2;
    return d;
  };
  result.carbon_carbon = of_bonds(lengths[0]);
  result.carbon_hydrogen = of_bonds(lengths[1]);
  result.hydrogen_hydrogen = of_bonds(lengths[2]);
  result.angles = distribution(angles, angle_bin);
  return result;
}

}  // namespace nanocarbon::analysis
