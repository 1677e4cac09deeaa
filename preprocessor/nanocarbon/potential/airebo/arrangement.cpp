// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/arrangement.h"

#include <algorithm>

namespace nanocarbon::airebo {

namespace {

bool same_cell(const std::optional<Cell>& a, const Cell* b) {
  if (!a || !b) return !a && !b;
  return a->vectors == b->vectors && a->periodic == b->periodic;
}

}  // namespace

void Arrangement::make(std::span<const Vec3> positions, std::span<const Element> elements, const Cell* cell,
                       double reach, double bond, double pair_reach) {
  bond_ = bond;
  sites_ = find_sites(positions, cell, reach);
  place_sites(positions, cell, sites_, coordinates_);
  elements_.clear();
  for (const potential::PeriodicCopy& site : sites_.sites) elements_.push_back(elements[site.of]);
  pairs_ = find_half_pairs(coordinates_, sites_, pair_reach);
  cell_ = cell ? std::optional<Cell>(*cell) : std::nullopt;
  made_ = true;
  find_near(positions);
}

bool Arrangement::is_of(std::span<const Element> elements, const Cell* cell) const {
  return made_ && elements.size() == sites_.own && same_cell(cell_, cell) &&
         std::equal(elements.begin(), elements.end(), elements_.begin());
}

bool Arrangement::near_is_good(std::span<const Vec3> positions) const {
  const double reach = 0.25 * skin_ * skin_;
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!((positions[i] - near_positions_[i]).squaredNorm() <= reach)) return false;
  return true;
}

void Arrangement::find_near(std::span<const Vec3> positions) {
  near_ = find_near_pairs(coordinates_, bond_ + skin_);
  near_positions_.assign(positions.begin(), positions.end());
}

NeighbourList Arrangement::as_neighbours(const potential::NearPairs& rows) const {
  NeighbourList list;
  list.offsets.assign(rows.offsets.begin(), rows.offsets.end());
  for (std::uint32_t i = 0; i < sites_.own; ++i)
    for (const std::uint32_t j : rows.of(i)) {
      Neighbour n = {sites_.sites[j].of, sites_.sites[j].image};
      for (int d = 0; d < 3; ++d) n.image[d] -= sites_.sites[i].image[d];
      list.neighbours.push_back(n);
    }
  return list;
}

}  // namespace nanocarbon::airebo
