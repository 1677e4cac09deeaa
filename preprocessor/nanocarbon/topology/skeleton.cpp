// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/topology/skeleton.h"

#include <fmt/format.h>

#include <limits>

#include "nanocarbon/topology/connected_components.h"

namespace nanocarbon::topology {
namespace {

constexpr std::uint32_t none = Skeleton::none;

// The half-edge of `end` back to `atom` whose vector is the opposite one. Several bonds between the same two
// atoms go through different images, so their vectors differ by a cell vector: far more than the two ends of
// one bond, which differ by rounding.
std::uint32_t find_twin(const EmbeddedGraph& graph, AtomIndex atom, std::uint32_t half_edge) {
  constexpr double same = 0.1;  // Angstrom
  const AtomIndex end = graph.ends[half_edge];
  std::uint32_t best = none;
  double best_distance = same * same;
  for (std::uint32_t h = graph.offsets[end]; h < graph.offsets[end + 1]; ++h) {
    if (graph.ends[h] != atom || h == half_edge) continue;
    const double distance = (graph.vectors[h] + graph.vectors[half_edge]).squaredNorm();
    if (distance < best_distance) {
      best = h;
      best_distance = distance;
    }
  }
  return best;
}

std::optional<NotASurface> pair_half_edges(const EmbeddedGraph& graph, std::vector<std::uint32_t>& twin) {
  twin.assign(graph.ends.size(), none);
  for (AtomIndex a = 0; a < graph.atoms(); ++a)
    for (std::uint32_t h = graph.offsets[a]; h < graph.offsets[a + 1]; ++h) {
      twin[h] = find_twin(graph, a, h);
      if (twin[h] == none)
        return NotASurface{fmt::format("the bond of atom ID {} with atom ID {} is known to only one of them",
                                       graph.id(a), graph.id(graph.ends[h])),
                           a};
    }
  for (std::uint32_t h = 0; h < twin.size(); ++h)
    if (twin[twin[h]] != h) {
      const AtomIndex a = graph.ends[twin[h]];
      return NotASurface{fmt::format("the bonds of atom ID {} with atom ID {} cannot be told apart",
                                     graph.id(a), graph.id(graph.ends[h])),
                         a};
    }
  return std::nullopt;
}

bool is_carbon(const EmbeddedGraph& graph, AtomIndex atom) { return graph.elements[atom] == Element::carbon; }

Components find_components(const EmbeddedGraph& graph) {
  DisjointSets sets(graph.atoms());
  for (AtomIndex a = 0; a < graph.atoms(); ++a) {
    if (is_carbon(graph, a)) {
      for (std::uint32_t h = graph.offsets[a]; h < graph.offsets[a + 1]; ++h)
        if (is_carbon(graph, graph.ends[h])) sets.join(a, graph.ends[h]);
      continue;
    }
    double nearest = std::numeric_limits<double>::infinity();
    AtomIndex holder = a;
    for (std::uint32_t h = graph.offsets[a]; h < graph.offsets[a + 1]; ++h)
      if (const double distance = graph.vectors[h].squaredNorm(); distance < nearest) {
        nearest = distance;
        holder = graph.ends[h];
      }
    sets.join(a, holder);
  }
  return numbered_components(graph.atoms(), sets);
}

// Takes away atoms with one bond until there are none; of a tree one atom without bonds is left.
void trim_trees(const EmbeddedGraph& graph, Skeleton& skeleton) {
  std::vector<AtomIndex> leaves;
  for (AtomIndex a = 0; a < graph.atoms(); ++a)
    if (skeleton.degree[a] == 1) leaves.push_back(a);
  while (!leaves.empty()) {
    const AtomIndex leaf = leaves.back();
    leaves.pop_back();
    for (std::uint32_t h = graph.offsets[leaf]; h < graph.offsets[leaf + 1]; ++h) {
      const std::uint32_t back = skeleton.twin[h];
      if (back == none) continue;
      skeleton.twin[h] = skeleton.twin[back] = none;
      --skeleton.degree[leaf];
      if (--skeleton.degree[graph.ends[h]] == 1) leaves.push_back(graph.ends[h]);
    }
  }
}

}  // namespace

Skeleton find_skeleton(const EmbeddedGraph& graph) {
  Skeleton skeleton;
  Components components = find_components(graph);
  skeleton.component = std::move(components.of_atom);
  skeleton.components = components.count;
  skeleton.problem = pair_half_edges(graph, skeleton.twin);
  if (skeleton.problem) return skeleton;

  skeleton.degree.assign(graph.atoms(), 0);
  for (AtomIndex a = 0; a < graph.atoms(); ++a) {
    std::uint32_t bonds = 0;
    for (std::uint32_t h = graph.offsets[a]; h < graph.offsets[a + 1]; ++h) {
      if (is_carbon(graph, a) && is_carbon(graph, graph.ends[h]))
        ++bonds;
      else
        skeleton.twin[h] = none;
    }
    if (bonds > 3) {
      skeleton.problem =
          NotASurface{fmt::format("atom ID {} is bonded to {} carbon atoms", graph.id(a), bonds), a};
      return skeleton;
    }
    skeleton.degree[a] = static_cast<std::uint8_t>(bonds);
  }
  trim_trees(graph, skeleton);
  return skeleton;
}

}  // namespace nanocarbon::topology
