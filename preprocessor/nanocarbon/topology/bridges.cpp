// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/topology/bridges.h"

#include <algorithm>

namespace nanocarbon::topology {
namespace {

constexpr std::uint32_t none = Skeleton::none;

// An atom that the search stands on, the half-edge to try next, and the one that it came by.
struct Visit {
  AtomIndex atom;
  std::uint32_t next;
  std::uint32_t arrived_by;
};

}  // namespace

std::vector<std::uint8_t> find_bridges(const EmbeddedGraph& graph, const Skeleton& skeleton) {
  std::vector<std::uint8_t> is_bridge(graph.ends.size(), 0);
  std::vector<std::uint32_t> order(graph.atoms(), none);   // in which atoms are met
  std::vector<std::uint32_t> lowest(graph.atoms(), none);  // order that can be reached from here on, without
                                                           // the bond that was arrived by
  std::uint32_t met = 0;
  std::vector<Visit> path;
  const auto enter = [&](AtomIndex atom, std::uint32_t arrived_by) {
    order[atom] = lowest[atom] = met++;
    path.push_back({atom, graph.offsets[atom], arrived_by});
  };
  for (AtomIndex root = 0; root < graph.atoms(); ++root) {
    if (skeleton.degree[root] == 0 || order[root] != none) continue;
    enter(root, none);
    while (!path.empty()) {
      const Visit here = path.back();
      if (here.next < graph.offsets[here.atom + 1]) {
        ++path.back().next;
        const bool goes_back = here.arrived_by != none && here.next == skeleton.twin[here.arrived_by];
        if (skeleton.twin[here.next] == none || goes_back) continue;
        const AtomIndex to = graph.ends[here.next];
        if (order[to] == none)
          enter(to, here.next);
        else
          lowest[here.atom] = std::min(lowest[here.atom], order[to]);
        continue;
      }
      path.pop_back();
      if (path.empty()) continue;
      const AtomIndex from = path.back().atom;
      lowest[from] = std::min(lowest[from], lowest[here.atom]);
      if (lowest[here.atom] > order[from])
        is_bridge[here.arrived_by] = is_bridge[skeleton.twin[here.arrived_by]] = 1;
    }
  }
  return is_bridge;
}

}  // namespace nanocarbon::topology
