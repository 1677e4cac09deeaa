// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/analysis/atom_matching.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "nanocarbon/core/neighbours_within.h"
#include "nanocarbon/core/space.h"

namespace nanocarbon::analysis {
namespace {

constexpr double far_move = 2.0;    // Angstrom, of which few atoms move from frame to frame
constexpr double near_place = 1.0;  // Angstrom, where an atom is looked for; below any two atoms' distance
constexpr std::size_t few = 20;     // one atom of so many

using Partner = std::optional<std::uint32_t>;

bool same_order(const Molecule& now, const Molecule& before, const Space& space) {
  if (now.elements != before.elements) return false;
  std::size_t far = 0;
  for (std::size_t i = 0; i < now.size(); ++i)
    far += space.displacement(before.positions[i], now.positions[i]).norm() > far_move;
  return far * few <= now.size();
}

// For each atom of both frames, now's first, the nearest of its element in the other frame.
std::vector<Partner> nearest_in_other(const Molecule& now, const Molecule& before, const Space& space) {
  std::vector<Vec3> positions = now.positions;
  positions.insert(positions.end(), before.positions.begin(), before.positions.end());
  const auto n = static_cast<std::uint32_t>(now.size());
  const auto element = [&](std::uint32_t a) { return a < n ? now.elements[a] : before.elements[a - n]; };
  const NeighbourList close = neighbours_within(positions, now.cell ? &*now.cell : nullptr, near_place);
  std::vector<Partner> nearest(positions.size());
  for (std::uint32_t a = 0; a < positions.size(); ++a) {
    double least = std::numeric_limits<double>::infinity();
    for (const Neighbour& b : close.of(a)) {
      if ((a < n) == (b.atom < n) || element(a) != element(b.atom)) continue;
      const double distance = space.displacement(positions[a], positions[b.atom]).squaredNorm();
      if (distance < least) {
        least = distance;
        nearest[a] = b.atom;
      }
    }
  }
  return nearest;
}

// Of now's atoms, those of the frame before that they are, by place.
std::vector<Partner> partners_by_place(const Molecule& now, const Molecule& before, const Space& space) {
  const auto n = static_cast<std::uint32_t>(now.size());
  const std::vector<Partner> nearest = nearest_in_other(now, before, space);
  std::vector<Partner> partners(n);
  for (std::uint32_t a = 0; a < n; ++a)
    if (nearest[a] && nearest[*nearest[a]] == a) partners[a] = *nearest[a] - n;
  return partners;
}

// Pairs what is left, the atoms of the frame now in turn, each with the nearest of its element.
void pair_the_rest(const Molecule& now, const Molecule& before, const Space& space,
                   std::vector<Partner>& partners) {
  std::vector<bool> taken(before.size(), false);
  for (const Partner& p : partners)
    if (p) taken[*p] = true;
  std::vector<std::uint32_t> left;
  for (std::uint32_t b = 0; b < before.size(); ++b)
    if (!taken[b]) left.push_back(b);
  for (std::uint32_t a = 0; a < now.size(); ++a) {
    if (partners[a]) continue;
    double least = std::numeric_limits<double>::infinity();
    auto best = left.end();
    for (auto b = left.begin(); b != left.end(); ++b) {
      if (now.elements[a] != before.elements[*b]) continue;
      const double distance = space.displacement(before.positions[*b], now.positions[a]).squaredNorm();
      if (distance < least) {
        least = distance;
        best = b;
      }
    }
    if (best == left.end()) continue;
    partners[a] = *best;
    left.erase(best);
  }
}

}  // namespace

AtomMatching match_atoms(const Molecule& now, const Molecule& before,
                         std::span<const std::int64_t> before_ids, std::int64_t next_id) {
  const Space space = now.cell ? Space(*now.cell) : Space();
  AtomMatching result;
  if (same_order(now, before, space)) {
    result.ids.assign(before_ids.begin(), before_ids.end());
    return result;
  }
  std::vector<Partner> partners = partners_by_place(now, before, space);
  const auto found = static_cast<std::size_t>(
      std::count_if(partners.begin(), partners.end(), [](const Partner& p) { return p.has_value(); }));
  const std::size_t wanted = std::min(now.size(), before.size());
  if (found * few < wanted * (few - 1)) {
    for (std::uint32_t a = 0; a < now.size(); ++a)
      partners[a] = a < before.size() ? Partner(a) : std::nullopt;
    result.doubt =
        "its atoms have no IDs, and too many of them are not where they were in the frame before: they are "
        "taken "
        "to be in the same order, and what is said of bonds broken and formed is wrong if they are not";
  } else {
    pair_the_rest(now, before, space, partners);
    result.doubt = now.size() == before.size() ? "its atoms have no IDs, and their order differs from that "
                                                 "of the frame before: they are told by "
                                                 "place"
                                               : fmt::format(
                                                     "its atoms have no IDs, and there are {} where the "
                                                     "frame before has {}: which ones are gone "
                                                     "or new is told by place",
                                                     now.size(), before.size());
  }
  for (const Partner& p : partners) result.ids.push_back(p ? before_ids[*p] : next_id++);
  return result;
}

}  // namespace nanocarbon::analysis
