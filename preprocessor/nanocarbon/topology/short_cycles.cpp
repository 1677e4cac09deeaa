// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/topology/short_cycles.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace nanocarbon::topology {
namespace {

// An atom and, as it may be met through different periodic images, where it is relative to the start.
struct Place {
  AtomIndex atom;
  Vec3 position;
};

using Key = std::tuple<AtomIndex, long, long, long>;

// Places of one atom differ by cell vectors, so a coarse grid tells them apart. One that lies on a line of
// the grid may get two keys by rounding, and is then visited twice.
Key key(const Place& place) {
  return {place.atom, std::lround(place.position[0]), std::lround(place.position[1]),
          std::lround(place.position[2])};
}

// All places within so many bonds of a start, sorted by atom, without crossing excluded half-edges.
std::vector<Place> places_within(const EmbeddedGraph& graph, const Skeleton& skeleton, const Place& start,
                                 int bonds, const std::vector<std::uint8_t>& excluded, std::uint32_t bond) {
  std::vector<Place> places = {start};
  std::set<Key> visited = {key(start)};
  std::size_t front = 0;
  for (int length = 0; length < bonds; ++length) {
    const std::size_t end = places.size();
    for (; front < end; ++front) {
      const Place from = places[front];
      for (std::uint32_t h = graph.offsets[from.atom]; h < graph.offsets[from.atom + 1]; ++h) {
        if (skeleton.twin[h] == Skeleton::none || excluded[h] || h == bond || skeleton.twin[h] == bond)
          continue;
        const Place there{graph.ends[h], from.position + graph.vectors[h]};
        if (visited.insert(key(there)).second) places.push_back(there);
      }
    }
  }
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.atom < b.atom; });
  return places;
}

}  // namespace

bool is_on_short_cycle(const EmbeddedGraph& graph, const Skeleton& skeleton, AtomIndex atom,
                       std::uint32_t half_edge, int most, const std::vector<std::uint8_t>& excluded) {
  constexpr double same = 0.1;  // Angstrom; rounding over a dozen bonds is far less
  // The rest of the cycle has at most most - 1 bonds: searched for from both ends, which meet in the middle.
  const int rest = most - 1;
  const Place near{atom, Vec3::Zero()}, far{graph.ends[half_edge], graph.vectors[half_edge]};
  const std::vector<Place> here = places_within(graph, skeleton, near, rest / 2, excluded, half_edge);
  const std::vector<Place> there = places_within(graph, skeleton, far, rest - rest / 2, excluded, half_edge);
  auto first = there.begin();
  for (const Place& place : here) {
    while (first != there.end() && first->atom < place.atom) ++first;
    for (auto other = first; other != there.end() && other->atom == place.atom; ++other)
      if ((other->position - place.position).norm() < same) return true;
  }
  return false;
}

}  // namespace nanocarbon::topology
