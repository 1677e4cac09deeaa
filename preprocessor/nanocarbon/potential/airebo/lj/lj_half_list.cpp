// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/lj/lj_half_list.h"

#include <algorithm>
#include <limits>

#include "nanocarbon/potential/airebo/lj/compact_order.h"

namespace nanocarbon::airebo {

namespace {

constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();
// A chunk is filled to less than what it can number.
constexpr std::uint32_t chunk_clusters = lj_most_clusters / 16;

template <class Action>
void for_all_pairs(const LjHalfList& half, const Action& action) {
  for (std::size_t r = 0; r < half.rows; ++r) {
    const int i = half.atoms[r];
    const int* row = half.neighbours[i];
    for (int k = 0; k < half.counts[i]; ++k)
      action(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(row[k] & half.neighbour_mask));
  }
}

std::vector<std::uint32_t> in_order(const std::vector<std::uint32_t>& atoms, const double* positions) {
  std::vector<Vec3> points(atoms.size());
  for (std::size_t a = 0; a < atoms.size(); ++a) points[a] = Vec3::Map(positions + 3 * std::size_t{atoms[a]});
  std::vector<std::uint32_t> order = compact_order(points, lj_lanes);
  for (std::uint32_t& o : order) o = atoms[o];
  return order;
}

}  // namespace

LjLists lists_from_half_list(const LjHalfList& half, const double* positions,
                             std::span<const Element> elements,
                             std::span<const std::array<std::uint32_t, 2>> exclusions) {
  // Atoms in any pair; those that have rows come first.
  constexpr std::uint8_t neighbour = 1, own = 2;
  std::vector<std::uint8_t> use(elements.size(), 0);
  for_all_pairs(half, [&](std::uint32_t, std::uint32_t j) { use[j] = neighbour; });
  for (std::size_t r = 0; r < half.rows; ++r) use[static_cast<std::size_t>(half.atoms[r])] = own;
  LjSites sites;
  std::size_t own_sites = 0;
  for (const std::uint8_t wanted : {own, neighbour}) {
    std::vector<std::uint32_t> atoms;
    for (std::uint32_t a = 0; a < use.size(); ++a)
      if (use[a] == wanted) atoms.push_back(a);
    if (wanted == own) own_sites = atoms.size();
    sites.add(in_order(atoms, positions), {}, elements);
  }
  std::vector<std::uint32_t> site_of(elements.size(), nowhere);
  for (std::uint32_t s = 0; s < sites.atoms.size(); ++s)
    if (sites.real[s / lj_lanes] >> s % lj_lanes & 1) site_of[sites.atoms[s]] = s;

  std::vector<std::array<std::uint32_t, 2>> excluded;
  for (const auto& [i, j] : exclusions)
    if (site_of[i] != nowhere && site_of[j] != nowhere) excluded.push_back({site_of[i], site_of[j]});
  const LjExcluded excluded_sites(std::move(excluded), sites.atoms.size());

  // Pairs of own atoms go to the one that comes first, so that rows have whole clusters; other atoms come after all of
  // these. Here and below without branches, since which way they go is hard to guess for a processor.
  std::vector<std::size_t> offsets(lj_lanes * ((own_sites + lj_lanes - 1) / lj_lanes) + 1, 0);
  for_all_pairs(half,
                [&](std::uint32_t i, std::uint32_t j) { ++offsets[std::min(site_of[i], site_of[j]) + 1]; });
  for (std::size_t s = 0; s + 1 < offsets.size(); ++s) offsets[s + 1] += offsets[s];
  std::vector<std::uint32_t> others(offsets.back());
  std::vector<std::size_t> next(offsets.begin(), offsets.end() - 1);
  for_all_pairs(half, [&](std::uint32_t i, std::uint32_t j) {
    const std::uint32_t a = site_of[i], b = site_of[j];
    others[next[std::min(a, b)]++] = std::max(a, b);
  });

  LjListBuilder builder(sites, excluded_sites, own_sites, chunk_clusters);
  std::vector<std::uint32_t> in_row(sites.clusters(), nowhere);
  std::vector<LjListBuilder::Partner> partners;
  for (std::uint32_t a = 0; a + 1 < offsets.size(); ++a) {
    partners.resize(offsets[a + 1] - offsets[a]);
    std::uint32_t count = 0;
    for (std::size_t k = offsets[a]; k < offsets[a + 1]; ++k) {
      const std::uint32_t cluster = others[k] / lj_lanes, lane = 1u << others[k] % lj_lanes;
      const bool is_new = in_row[cluster] == nowhere;
      const std::uint32_t at = is_new ? count : in_row[cluster];
      in_row[cluster] = at;
      partners[at] = {cluster, is_new ? lane : partners[at].mask | lane};
      count += is_new;
    }
    partners.resize(count);
    for (const auto& p : partners) in_row[p.cluster] = nowhere;
    if (!partners.empty()) builder.add_row(a, partners);
  }
  LjLists lists = builder.finish(elements.size());
  lists.images = {{0, 0, 0}};
  lists.margin = std::numeric_limits<double>::infinity();
  return lists;
}

}  // namespace nanocarbon::airebo
