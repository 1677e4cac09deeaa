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

// Triangles that are looked at in all to find a smaller number than the first that does.
constexpr std::size_t most_facets = 300'000;
constexpr int most_checks = 8;

}  // namespace

AtomsForFeatures atoms_for_features(const TriangleMesh& surface, double atoms, const FeatureReport& report,
                                    const FeatureLimits& limits, unsigned threads) {
  const double most = std::max(3e5, 4 * atoms);
  std::size_t facets = 0;
  const auto check = [&](double number) {
    TriangleMesh scaled = surface;
    rescale(scaled, std::sqrt(number / atoms));
    FeatureReport checked = check_features(scaled, limits, threads);
    facets += checked.facets;
    return checked;
  };
  const auto grown = [](double number, const FeatureReport& r) {
    return number * r.enlargement * r.enlargement;
  };
  // Ranks below this are refused, or fewer than the surface has room for.
  std::size_t least = TwoDigits::from(atoms).rank;
  double wanted = grown(atoms, report);
  std::optional<TwoDigits> taken;
  for (int checks = 0; !taken; ++checks) {
    if (!(wanted <= most) || checks == most_checks) return {std::nullopt, most};
    const TwoDigits next{std::max(TwoDigits::from(wanted).rank, least)};
    const FeatureReport checked = check(next.value());
    if (checked.ok()) taken = next;
    least = checked.ok() ? least : next.rank + 1;
    wanted = grown(next.value(), checked);
  }
  // Smaller ones are tried first where they are most likely, next below.
  std::size_t step = 1;
  while (least < taken->rank && facets < most_facets) {
    const TwoDigits next{std::max(least, taken->rank - std::min(step, taken->rank))};
    if (check(next.value()).ok()) {
      taken = next;
      step *= 2;
    } else {
      least = next.rank + 1;
      step = std::max<std::size_t>(1, (taken->rank - least) / 2);
    }
  }
  return {static_cast<std::size_t>(std::llround(taken->value())), most};
}

}  // namespace nanocarbon::features
