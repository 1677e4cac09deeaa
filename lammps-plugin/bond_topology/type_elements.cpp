// SPDX-License-Identifier: GPL-2.0-or-later
#include "bond_topology/type_elements.h"

#include <algorithm>
#include <cstdio>
#include <limits>

#include "nanocarbon/core/periodic_table.h"

namespace nanocarbon {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::optional<AtomicNumber> by_mass(const WatchedType& type) {
  const auto lightest = atomic_number_of_mass(type.lightest);
  return lightest == atomic_number_of_mass(type.heaviest) ? lightest : std::nullopt;
}

std::string described(const WatchedType& type) {
  const bool one = type.lightest == type.heaviest;
  return "type " + std::to_string(type.type) + (one ? " (mass " : " (masses ") + number(type.lightest) +
         (one ? "" : " to " + number(type.heaviest)) + ")";
}

}  // namespace

std::vector<WatchedType> watched_types(MPI_Comm world, int all_types, std::span<const int> types,
                                       std::span<const double> masses) {
  // The largest of each type's mass and of its negative: one reduction for both ends.
  const auto n = static_cast<std::size_t>(all_types) + 1;
  constexpr double none = -std::numeric_limits<double>::infinity();
  std::vector<double> own(2 * n, none), all(2 * n);
  for (std::size_t i = 0; i < types.size(); ++i) {
    const auto type = static_cast<std::size_t>(types[i]);
    own[type] = std::max(own[type], masses[i]);
    own[n + type] = std::max(own[n + type], -masses[i]);
  }
  MPI_Allreduce(own.data(), all.data(), static_cast<int>(all.size()), MPI_DOUBLE, MPI_MAX, world);
  std::vector<WatchedType> watched;
  for (std::size_t type = 1; type < n; ++type)
    if (all[type] != none) watched.push_back({static_cast<int>(type), -all[n + type], all[type]});
  return watched;
}

TypeElements type_elements(int all_types, const std::vector<WatchedType>& types, const SaidElements& said) {
  TypeElements result;
  result.of_type.assign(static_cast<std::size_t>(all_types) + 1, Element::carbon);
  for (const WatchedType& type : types) {
    const auto index = static_cast<std::size_t>(type.type);
    std::optional<Element> element = index < said.of_type.size() ? said.of_type[index] : std::nullopt;
    const std::string by = element ? " by " + said.by : "";
    const auto z = by_mass(type);
    if (!element && z == 6) element = Element::carbon;
    if (!element && z == 1) element = Element::hydrogen;
    if (!element) {
      result.problem = "atom " + described(type) + " is " +
                       (z ? std::string(element_name(*z)) : std::string("no element by its mass")) +
                       ": leave its atoms out of the group, or say what each type is by the keyword element";
      return result;
    }
    result.of_type[index] = *element;
    result.summary += (result.summary.empty() ? "" : ", ") + described(type) + " is " +
                      (*element == Element::carbon ? "carbon" : "hydrogen") + by;
  }
  return result;
}

}  // namespace nanocarbon
