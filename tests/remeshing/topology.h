// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::test {

//! What must not change; counted here from the triangles alone, apart from the code under test.
struct Topology {
  bool manifold = true;  //!< oriented, no edge of three triangles, one fan at every vertex
  long euler_characteristic = 0;
  std::size_t components = 0;
  std::size_t boundary_loops = 0;
  friend bool operator==(const Topology&, const Topology&) = default;
};

inline Topology topology_of(const TriangleMesh& mesh) {
  Topology topology;
  std::map<std::array<VertexIndex, 2>, int> directed;
  std::map<VertexIndex, std::map<VertexIndex, VertexIndex>> fans;  // vertex -> next neighbour around it
  std::vector<std::size_t> component(mesh.points.size());
  std::iota(component.begin(), component.end(), 0);
  const auto root = [&](std::size_t v) {
    while (component[v] != v) v = component[v] = component[component[v]];
    return v;
  };
  for (const Triangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const VertexIndex a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
      if (a == b || ++directed[{a, b}] > 1) topology.manifold = false;
      fans[a][b] = c;
      component[root(a)] = root(b);
    }
  long edges = 0;
  std::map<VertexIndex, VertexIndex> boundary;  // along the hole
  for (const auto& [edge, count] : directed) {
    const bool open = !directed.contains({edge[1], edge[0]});
    edges += open || edge[0] < edge[1];
    if (open && !boundary.emplace(edge[1], edge[0]).second) topology.manifold = false;
  }
  for (const auto& [v, next] : fans) {
    VertexIndex start = next.begin()->first;
    for (const auto& [n, m] : next)
      if (std::none_of(next.begin(), next.end(), [n = n](const auto& e) { return e.second == n; })) start = n;
    std::size_t turned = 0;
    for (auto at = next.find(start); at != next.end() && turned <= next.size(); at = next.find(at->second)) {
      ++turned;
      if (at->second == start) break;
    }
    if (turned != next.size()) topology.manifold = false;
  }
  std::set<std::size_t> roots;
  for (const auto& [v, next] : fans) roots.insert(root(v));
  topology.components = roots.size();
  topology.euler_characteristic =
      static_cast<long>(fans.size()) - edges + static_cast<long>(mesh.triangles.size());
  while (!boundary.empty()) {
    ++topology.boundary_loops;
    for (auto at = boundary.begin(); at != boundary.end();) {
      const VertexIndex to = at->second;
      boundary.erase(at);
      at = boundary.find(to);
    }
  }
  return topology;
}

}  // namespace nanocarbon::test
