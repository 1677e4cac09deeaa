// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/solid/mesh_parts.h"

#include <algorithm>

namespace nanocarbon::mesh {

TriangleMesh part_of(const TriangleMesh& mesh, const std::vector<FaceIndex>& faces) {
  std::vector<VertexIndex> used;
  used.reserve(3 * faces.size());
  for (const FaceIndex face : faces)
    used.insert(used.end(), mesh.triangles[face].begin(), mesh.triangles[face].end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  TriangleMesh part;
  for (const VertexIndex v : used) part.points.push_back(mesh.points[v]);
  for (const FaceIndex face : faces) {
    Triangle& triangle = part.triangles.emplace_back(mesh.triangles[face]);
    for (VertexIndex& v : triangle)
      v = static_cast<VertexIndex>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
  }
  return part;
}

void append(TriangleMesh& mesh, const TriangleMesh& part) {
  const auto shift = static_cast<VertexIndex>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), part.points.begin(), part.points.end());
  for (const auto& [a, b, c] : part.triangles) mesh.triangles.push_back({a + shift, b + shift, c + shift});
}

}  // namespace nanocarbon::mesh
