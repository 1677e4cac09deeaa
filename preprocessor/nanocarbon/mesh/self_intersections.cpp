// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/self_intersections.h"

#include <algorithm>

#include "nanocarbon/mesh/triangle_intersection.h"
#include "nanocarbon/mesh/triangle_tree.h"

namespace nanocarbon::mesh {
namespace {

constexpr std::size_t most_pairs = 100'000;
constexpr std::size_t most_tries_per_triangle = 64;  // a surface of even triangles needs about 10
constexpr std::size_t tries_always_allowed = 20'000'000;

}  // namespace

SelfIntersections self_intersections(const TriangleMesh& mesh) {
  SelfIntersections result;
  const TriangleTree tree = triangle_tree(mesh);
  std::vector<BoundingBox> boxes(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const VertexIndex v : mesh.triangles[t]) boxes[t].include(mesh.points[v]);
  const std::size_t most_tries = tries_always_allowed + most_tries_per_triangle * mesh.triangles.size();
  std::size_t tries = 0;
  for (const std::uint32_t first : tree.triangles) {
    const BoundingBox& box = boxes[first];
    visit_triangles(
        tree, [&](const BoundingBox& other) { return overlap(box, other); },
        [&](std::uint32_t second) {
          if (second <= first || !overlap(box, boxes[second])) return;
          ++tries;
          if (intersect(mesh, mesh.triangles[first], mesh.triangles[second]))
            result.pairs.push_back({first, second});
        });
    if (tries > most_tries || result.pairs.size() > most_pairs) {
      result.complete = false;
      break;
    }
  }
  std::sort(result.pairs.begin(), result.pairs.end());
  return result;
}

}  // namespace nanocarbon::mesh
