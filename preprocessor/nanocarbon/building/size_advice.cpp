// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/size_advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nanocarbon/building/size_request.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/remeshing/features/atoms_for_features.h"

namespace nanocarbon::building {
namespace {

constexpr double step = 1.25;  // to the next size where one does not hold
constexpr int most_tries = 6;

std::optional<std::size_t> with_room_for_features(const SizeSearch& search, double atoms,
                                                  const features::FeatureReport& report) {
  TriangleMesh scaled = search.surface;
  const double factor = std::sqrt(atoms * area_per_atom(search.bond_length) / mesh::area(scaled));
  for (Vec3& p : scaled.points) p *= factor;
  return features::atoms_for_features(scaled, atoms, report, {}, search.threads);
}

}  // namespace

SizeFound next_size(const SizeSearch& search, double atoms, const features::FeatureReport* report,
                    double effort) {
  SizeFound found;
  double wanted = atoms;
  for (int i = 0; i < most_tries; ++i, report = nullptr) {
    const auto number = with_room_for_features(search, wanted, report ? *report : features::FeatureReport{});
    found.searched = std::max(found.searched, wanted);
    if (!number) return found;
    const auto size = static_cast<double>(*number);
    if (*number > search.largest_tried) {
      found.atoms = number;
      return found;
    }
    if (size > effort) return found;
    effort -= size;
    found.searched = size;
    if (search.holds(*number)) {
      found.atoms = number;
      found.tried = true;
      return found;
    }
    wanted = step * size;
  }
  return found;
}

std::string advice(const SizeFound& found) {
  if (found.atoms && found.tried)
    return fmt::format(
        "ask for --atoms {}, the next size for which a draft holds, or build anyway with --force",
        *found.atoms);
  if (found.atoms)
    return fmt::format(
        "the next size that leaves no feature too small is --atoms {}; ask for that, or build anyway with "
        "--force",
        *found.atoms);
  return fmt::format(
      "no number of atoms up to {:.0f} was found that works; build anyway with --force, or change the shape",
      found.searched);
}

}  // namespace nanocarbon::building
