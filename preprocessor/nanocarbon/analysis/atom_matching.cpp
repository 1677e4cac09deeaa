// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/analysis/atom_matching.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "nanocarbon/core/neighbours_within.h"
#include "nanocarbon/core/space.h"

namespace nanocarbon::analysis {
namespace {

// Angstrom, half a bond: beyond what the whole moves by, few atoms move so far.
constexpr double far_move = 0.7;
constexpr double near_place = 1.0;  // Angstrom, where an atom is looked for; below any two atoms' distance
constexpr std::size_t few = 20;     // one atom of so many

using Partner = std::optional<std::uint32_t>;

// How far atoms of the same place in both files move, in the root mean square and apart from what the whole moves by,
// and how many of them move far.
struct Moves {
  double root_mean_square = std::numeric_limits<double>::infinity();
  std::size_t far = 0;
};

Moves moves_in_order(const Molecule& now, const Molecule& before, const Space& space) {
  const std::size_t n = now.size();
  // Images are nearest to where the first atom's move would take them: a drift may be longer than half the cell.
  const Vec3 first = space.displacement(before.positions[0], now.positions[0]);
  std::vector<Vec3> moves(n);
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 0; i < n; ++i) {
    moves[i] = first + space.displacement(before.positions[i] + first, now.positions[i]);
    mean += moves[i] / static_cast<double>(n);
  }
  Moves result{0.0, 0};
  for (const Vec3& move : moves) {
    const double squared = (move - mean).squaredNorm();
    result.root_mean_square += squared / static_cast<double>(n);
    result.far += squared > far_move * far_move;
  }
  result.root_mean_square = std::sqrt(result.root_mean_square);
  return result;
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
  const bool same_elements = now.elements == before.elements;
  const Moves in_order = same_elements ? moves_in_order(now, before, space) : Moves{};
  if (same_elements && in_order.far == 0) {
    result.ids.assign(before_ids.begin(), before_ids.end());
    return result;
  }
  std::vector<Partner> partners = partners_by_place(now, before, space);
  std::size_t found = 0;
  double squared = 0;
  for (std::size_t a = 0; a < partners.size(); ++a)
    if (partners[a]) {
      ++found;
      squared += space.displacement(before.positions[*partners[a]], now.positions[a]).squaredNorm();
    }
  const bool by_place = found * few >= std::min(now.size(), before.size()) * (few - 1);
  // By place only where that explains the frame much better than the order does.
  const double root_mean_square = std::sqrt(squared / static_cast<double>(std::max<std::size_t>(found, 1)));
  if (same_elements && !(by_place && root_mean_square < 0.5 * in_order.root_mean_square)) {
    result.ids.assign(before_ids.begin(), before_ids.end());
    if (in_order.far * few > now.size())
      result.doubt =
          "its atoms have no IDs, and many of them are not where they were in the frame before: they are "
          "taken to be in "
          "the same order, and what is said of bonds broken and formed is wrong if they are not";
    return result;
  }
  if (!by_place) {
    for (std::uint32_t a = 0; a < now.size(); ++a)
      partners[a] = a < before.size() ? Partner(a) : std::nullopt;
    result.doubt =
        "its atoms have no IDs, other elements or another number than the frame before, and too many of them "
        "are not "
        "where they were: they are taken to be in the same order, and what is said of bonds broken and "
        "formed is wrong "
        "if they are not";
  } else {
    pair_the_rest(now, before, space, partners);
    result.doubt =
        now.size() == before.size()
            ? "its atoms have no IDs, and their order differs from that of the frame before: they are told "
              "by "
              "place"
            : fmt::format(
                  "its atoms have no IDs, and there are {} where the frame before has {}: which ones are "
                  "gone or new is told by place",
                  now.size(), before.size());
  }
  for (const Partner& p : partners) result.ids.push_back(p ? before_ids[*p] : next_id++);
  return result;
}

}  // namespace nanocarbon::analysis
