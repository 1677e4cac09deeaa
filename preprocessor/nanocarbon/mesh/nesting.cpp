// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/nesting.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "nanocarbon/mesh/triangle_intersection.h"
#include "nanocarbon/mesh/triangle_tree.h"

namespace nanocarbon::mesh {
namespace {

constexpr std::size_t most_components = 10'000;

// Components that a point is inside of: those that a ray from it goes through an odd number of times. Nothing
// when the ray met an edge or a vertex.
std::optional<std::vector<std::uint32_t>> around(const TriangleMesh& mesh, const MeshTopology& topology,
                                                 const TriangleTree& tree, std::uint32_t component,
                                                 const Vec3& direction) {
  const Vec3 from = mesh.points[mesh.triangles[topology.component[component].first_face][0]];
  const BoundingBox& all = tree.nodes[0].box;
  const Vec3 to = from + 2.0 * all.diagonal() * direction;
  std::vector<std::uint32_t> crossed;
  bool degenerate = false;
  visit_triangles(
      tree, [&](const BoundingBox& box) { return meets_segment(box, from, to); },
      [&](std::uint32_t t) {
        const std::uint32_t other = topology.component_of_face[t];
        if (other == component || topology.component[other].boundary_loops > 0) return;
        const auto& [a, b, c] = mesh.triangles[t];
        switch (crossing(from, to, mesh.points[a], mesh.points[b], mesh.points[c])) {
          case Crossing::through:
            crossed.push_back(other);
            break;
          case Crossing::degenerate:
            degenerate = true;
            break;
          case Crossing::none:
            break;
        }
      });
  if (degenerate) return std::nullopt;
  std::sort(crossed.begin(), crossed.end());
  std::vector<std::uint32_t> inside;
  for (auto at = crossed.begin(); at != crossed.end();) {
    const auto end = std::upper_bound(at, crossed.end(), *at);
    if ((end - at) % 2 == 1) inside.push_back(*at);
    at = end;
  }
  return inside;
}

}  // namespace

std::vector<std::uint32_t> outermost_around(const TriangleMesh& mesh, const MeshTopology& topology) {
  std::vector<std::uint32_t> outermost(topology.components);
  std::iota(outermost.begin(), outermost.end(), 0u);
  if (topology.components < 2 || topology.components > most_components) return outermost;
  const TriangleTree tree = triangle_tree(mesh);
  std::vector<std::vector<std::uint32_t>> enclosing(topology.components);
  for (std::uint32_t component = 0; component < topology.components; ++component)
    for (int attempt = 0; attempt < 10; ++attempt) {
      const Vec3 direction = Vec3(0.5 + 0.1 * attempt, 0.3183, 0.7712 - 0.13 * attempt).normalized();
      if (auto found = around(mesh, topology, tree, component, direction)) {
        enclosing[component] = std::move(*found);
        break;
      }
    }
  for (std::uint32_t component = 0; component < topology.components; ++component)
    for (const std::uint32_t other : enclosing[component])
      if (enclosing[other].empty()) outermost[component] = other;
  return outermost;
}

}  // namespace nanocarbon::mesh
