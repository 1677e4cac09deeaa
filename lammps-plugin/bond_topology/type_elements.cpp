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

// 0 where the masses are no element's, or of several.
int atomic_number_by_mass(const WatchedType& type) {
  const int lightest = atomic_number_of_mass(type.lightest).value_or(0);
  return lightest == atomic_number_of_mass(type.heaviest).value_or(0) ? lightest : 0;
}

// 0 where nothing is said.
int atomic_number_said(const SaidElements& said, int type) {
  const auto index = static_cast<std::size_t>(type);
  if (index >= said.of_type.size() || !said.of_type[index]) return 0;
  return said.of_type[index] == Element::carbon ? 6 : 1;
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
    const int as_said = atomic_number_said(said, type.type);
    const int z = as_said != 0 ? as_said : atomic_number_by_mass(type);
    if (z != 6 && z != 1) {
      result.problem = "atom " + described(type) + " is " +
                       (z == 0 ? std::string("no element by its mass")
                               : std::string(element_name(static_cast<AtomicNumber>(z)))) +
                       ": leave its atoms out of the group, or say what each type is by the keyword element";
      return result;
    }
    result.of_type[static_cast<std::size_t>(type.type)] = z == 6 ? Element::carbon : Element::hydrogen;
    result.summary += (result.summary.empty() ? "" : ", ") + described(type) + " is " +
                      (z == 6 ? "carbon" : "hydrogen") + (as_said != 0 ? " by " + said.by : "");
  }
  return result;
}

}  // namespace nanocarbon
