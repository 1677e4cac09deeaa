// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/features/atoms_for_features.h"

#include <algorithm>
#include <cmath>

namespace nanocarbon::features {
namespace {

// A number of two digits: those from 10 to 99, then 100, 110 and so on, 90 to each power of ten.
struct TwoDigits {
  std::size_t rank = 0;  // 0 is 10

  double value() const {
    return static_cast<double>(10 + rank % 90) * std::pow(10.0, static_cast<double>(rank / 90));
  }
  // The smallest that is not below a number.
  static TwoDigits from(double number) {
    const double power = std::max(1.0, std::floor(std::log10(number)));
    TwoDigits result{90 * static_cast<std::size_t>(power - 1)};
    while (result.value() < number) ++result.rank;
    return result;
  }
};

// By how much lengths should grow for the worst problem.
double enlargement(const FeatureReport& report) {
  return report.problems.front().needed / report.problems.front().size;
}

}  // namespace

std::optional<std::size_t> atoms_for_features(const TriangleMesh& surface, double atoms,
                                              const FeatureLimits& limits, unsigned threads) {
  const double most = std::max(3e5, 4 * atoms);
  const auto check = [&](double number) {
    TriangleMesh scaled = surface;
    for (Vec3& p : scaled.points) p *= std::sqrt(number / atoms);
    return check_features(scaled, limits, threads);
  };
  TwoDigits refused = TwoDigits::from(atoms);
  TwoDigits taken = refused;
  for (FeatureReport report = check(taken.value()); !report.ok(); report = check(taken.value())) {
    refused = taken;
    const double grown = taken.value() * enlargement(report) * enlargement(report);
    if (!(grown <= most)) return std::nullopt;
    taken = {std::max(TwoDigits::from(grown).rank, refused.rank + 1)};
  }
  while (refused.rank + 1 < taken.rank) {
    const TwoDigits middle{(refused.rank + taken.rank) / 2};
    (check(middle.value()).ok() ? taken : refused) = middle;
  }
  return static_cast<std::size_t>(std::llround(taken.value()));
}

}  // namespace nanocarbon::features
