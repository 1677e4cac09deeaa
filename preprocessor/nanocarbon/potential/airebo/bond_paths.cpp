// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/bond_paths.h"

namespace nanocarbon::airebo {

using rebo2::Centre;
using rebo2::HalfEdge;
using rebo2::HalfEdges;

void BondPaths::offer(const BondPath& path) {
  if (path.weight == 0.0) return;
  if (path.to >= place_.size()) place_.resize(path.to + std::size_t{1}, nowhere);
  std::uint32_t& place = place_[path.to];
  if (place == nowhere) {
    place = static_cast<std::uint32_t>(paths_.size());
    paths_.push_back(path);
  } else if (path.weight > paths_[place].weight) {
    paths_[place] = path;
  }
}

void BondPaths::find(HalfEdges& edges, std::uint32_t from) {
  for (const BondPath& path : paths_) place_[path.to] = nowhere;
  paths_.clear();
  const auto for_each_bond = [&](std::uint32_t atom, auto&& visit) {
    const Centre& centre = edges.centre(atom);
    for (std::uint32_t e = centre.first; e < centre.first + centre.count; ++e) visit(e, edges[e]);
  };
  for_each_bond(from, [&](std::uint32_t a, const HalfEdge& first) {
    offer({first.to, 1, first.weight, {a, 0, 0}});
  });
  for_each_bond(from, [&](std::uint32_t a, const HalfEdge& first) {
    for_each_bond(first.to, [&](std::uint32_t b, const HalfEdge& second) {
      if (second.to != from) offer({second.to, 2, first.weight * second.weight, {a, b, 0}});
    });
    for_each_bond(first.to, [&](std::uint32_t b, const HalfEdge& second) {
      const double weight = first.weight * second.weight;
      if (second.to == from || weight == 0.0) return;
      for_each_bond(second.to, [&](std::uint32_t c, const HalfEdge& third) {
        if (third.to != from && third.to != first.to) offer({third.to, 3, weight * third.weight, {a, b, c}});
      });
    });
  });
}

}  // namespace nanocarbon::airebo
