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

features::AtomsForFeatures with_room_for_features(const SizeSearch& search, double atoms,
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
  for (int i = 0; i < search.most_tries; ++i, report = nullptr) {
    const features::AtomsForFeatures fitting =
        with_room_for_features(search, wanted, report ? *report : features::FeatureReport{});
    if (!fitting.atoms) {
      found.refused_to = fitting.most;
      return found;
    }
    const auto size = static_cast<double>(*fitting.atoms);
    if (*fitting.atoms > search.largest_tried) {
      found.atoms = fitting.atoms;
      return found;
    }
    if (size > effort) return found;
    effort -= size;
    if (search.holds(*fitting.atoms)) {
      found.atoms = fitting.atoms;
      found.tried = true;
      return found;
    }
    found.largest_failed = *fitting.atoms;
    wanted = step * size;
  }
  return found;
}

std::string why_none(const SizeFound& found) {
  const std::string tried = found.largest_failed > 0
                                ? fmt::format("drafts of up to {} atoms do not hold", found.largest_failed)
                                : "";
  if (found.refused_to > 0)
    return tried + (tried.empty() ? "" : ", and ") +
           fmt::format("no number of atoms up to {:.0f} was found that leaves no feature too small",
                       found.refused_to);
  return tried.empty() ? "which number of atoms would do takes too long to find out"
                       : tried + ", and larger ones were not tried";
}

std::string advice(const SizeFound& found) {
  if (found.atoms && found.tried)
    return fmt::format(
        "ask for --atoms {}, the next size for which a draft holds, or build anyway with --force",
        *found.atoms);
  if (found.atoms)
    return fmt::format(
        "the next size that leaves no feature too small is --atoms {}, of which no draft was made to see "
        "whether it holds; ask for that, or build anyway with --force",
        *found.atoms);
  return why_none(found) + "; build anyway with --force, or change the shape";
}

}  // namespace nanocarbon::building
