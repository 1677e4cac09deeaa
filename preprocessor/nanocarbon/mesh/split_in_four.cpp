// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/split_in_four.h"

#include <vector>

#include "nanocarbon/mesh/edge_table.h"

namespace nanocarbon::mesh {

TriangleMesh split_in_four(const TriangleMesh& mesh) {
  const EdgeTable edges = edge_table(soup_of(mesh));
  TriangleMesh fine;
  fine.points = mesh.points;
  fine.space = mesh.space;
  fine.points.reserve(mesh.points.size() + edges.size());
  std::vector<VertexIndex> middle(3 * mesh.triangles.size());  // of the side that begins at a corner
  for (std::size_t e = 0; e < edges.size(); ++e) {
    for (const EdgeUse& use : edges.uses_of(e))
      middle[use.corner] = static_cast<VertexIndex>(fine.points.size());
    const Vec3& low = mesh.points[edges.low[e]];
    fine.points.push_back(0.5 * (low + mesh.space.beside(mesh.points[edges.high[e]], low)));
  }
  fine.triangles.reserve(4 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const VertexIndex ab = middle[3 * t], bc = middle[3 * t + 1], ca = middle[3 * t + 2];
    for (const Triangle& part : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
      fine.triangles.push_back(part);
  }
  return fine;
}

}  // namespace nanocarbon::mesh
