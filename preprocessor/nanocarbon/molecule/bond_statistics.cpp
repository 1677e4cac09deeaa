// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/bond_statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nanocarbon::molecule {
namespace {

Vec3 vector_along(const Molecule& molecule, const Bond& bond) {
  const Vec3 inside = molecule.positions[bond.second] - molecule.positions[bond.first];
  return molecule.cell ? Vec3(inside + image_shift(*molecule.cell, bond.image)) : inside;
}

}  // namespace

Spread spread(std::span<const double> values) {
  Spread result;
  result.count = values.size();
  if (values.empty()) return result;
  const auto [min, max] = std::minmax_element(values.begin(), values.end());
  result.min = *min;
  result.max = *max;
  double sum = 0.0;
  for (const double v : values) sum += v;
  result.mean = sum / static_cast<double>(values.size());
  double squares = 0.0;
  for (const double v : values) squares += (v - result.mean) * (v - result.mean);
  result.deviation = std::sqrt(squares / static_cast<double>(values.size()));
  return result;
}

LengthStatistics length_statistics(std::span<const double> lengths, const Interval& interval,
                                   std::size_t bins) {
  LengthStatistics result;
  result.lengths = spread(lengths);
  result.histogram.assign(bins, 0);
  const double bins_per_length = static_cast<double>(bins) / (interval.high - interval.low);
  for (const double length : lengths) {
    if (length < interval.low) {
      ++result.below;
    } else if (length > interval.high) {
      ++result.above;
    } else {
      const auto bin = static_cast<std::size_t>((length - interval.low) * bins_per_length);
      ++result.histogram[std::min(bin, bins - 1)];
    }
  }
  if (!lengths.empty())
    result.fraction_outside =
        static_cast<double>(result.below + result.above) / static_cast<double>(lengths.size());
  return result;
}

std::vector<double> bond_lengths(const Molecule& molecule) {
  std::vector<double> lengths;
  lengths.reserve(molecule.bonds.size());
  for (const Bond& bond : molecule.bonds) lengths.push_back(vector_along(molecule, bond).norm());
  return lengths;
}

std::vector<double> bond_angles(const Molecule& molecule) {
  // Unit vectors of all bond ends in rows by atom.
  std::vector<std::uint32_t> start(molecule.size() + 1, 0);
  for (const Bond& bond : molecule.bonds) ++start[bond.first + 1], ++start[bond.second + 1];
  for (std::size_t a = 0; a < molecule.size(); ++a) start[a + 1] += start[a];
  std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
  std::vector<Vec3> along(2 * molecule.bonds.size());
  for (const Bond& bond : molecule.bonds) {
    const Vec3 unit = vector_along(molecule, bond).normalized();
    along[fill[bond.first]++] = unit;
    along[fill[bond.second]++] = -unit;
  }
  std::vector<double> angles;
  angles.reserve(along.size());
  for (std::size_t a = 0; a < molecule.size(); ++a)
    for (std::uint32_t i = start[a]; i < start[a + 1]; ++i)
      for (std::uint32_t j = i + 1; j < start[a + 1]; ++j)
        angles.push_back(std::acos(std::clamp(along[i].dot(along[j]), -1.0, 1.0)) * 180.0 / std::numbers::pi);
  return angles;
}

}  // namespace nanocarbon::molecule
