#include "nanocarbon/molecule/short_cycles.h"

#include <cmath>
#include <set>
#include <tuple>

namespace nanocarbon {
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

}  // namespace

bool is_on_short_cycle(const EmbeddedGraph& graph, const Skeleton& skeleton, AtomIndex atom,
                       std::uint32_t half_edge, int most, const std::vector<std::uint8_t>& excluded) {
  constexpr double same = 0.1;  // Angstrom; rounding over a dozen bonds is far less
  const Place goal{graph.ends[half_edge], graph.vectors[half_edge]};
  std::vector<Place> front = {{atom, Vec3::Zero()}}, next;
  std::set<Key> visited = {key(front[0])};
  for (int length = 1; length < most && !front.empty(); ++length) {
    next.clear();
    for (const Place& place : front)
      for (std::uint32_t h = graph.offsets[place.atom]; h < graph.offsets[place.atom + 1]; ++h) {
        if (skeleton.twin[h] == Skeleton::none || excluded[h] || h == half_edge ||
            skeleton.twin[h] == half_edge)
          continue;
        const Place there{graph.ends[h], place.position + graph.vectors[h]};
        if (there.atom == goal.atom && (there.position - goal.position).norm() < same) return true;
        if (visited.insert(key(there)).second) next.push_back(there);
      }
    front.swap(next);
  }
  return false;
}

}  // namespace nanocarbon
