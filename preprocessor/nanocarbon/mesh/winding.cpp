// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/winding.h"

#include <utility>
#include <vector>

#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/nesting.h"

namespace nanocarbon::mesh {
namespace {

void turn(Triangle& triangle) { std::swap(triangle[1], triangle[2]); }

}  // namespace

std::size_t wind_alike(TriangleMesh& mesh, const MeshTopology& topology, const EdgeTable& edges) {
  DisjointSets sides = face_sides(mesh.triangles.size(), edges);
  const auto differs = [&](FaceIndex face) {
    return sides.find(2 * face) !=
           sides.find(2 * topology.component[topology.component_of_face[face]].first_face);
  };
  std::vector<std::size_t> different(topology.components, 0);
  for (FaceIndex face = 0; face < mesh.triangles.size(); ++face)
    if (differs(face)) ++different[topology.component_of_face[face]];
  std::size_t turned = 0;
  for (FaceIndex face = 0; face < mesh.triangles.size(); ++face) {
    const std::uint32_t p = topology.component_of_face[face];
    if (!topology.component[p].orientable) continue;
    const bool turn_the_different = different[p] <= topology.component[p].faces / 2;
    if (differs(face) != turn_the_different) continue;
    turn(mesh.triangles[face]);
    ++turned;
  }
  return turned;
}

std::size_t turn_outside(TriangleMesh& mesh, const MeshTopology& topology) {
  std::vector<double> volume(topology.components, 0.0);
  for (FaceIndex face = 0; face < mesh.triangles.size(); ++face) {
    const std::uint32_t p = topology.component_of_face[face];
    const Vec3 origin = mesh.points[mesh.triangles[topology.component[p].first_face][0]];
    const auto& [a, b, c] = mesh.triangles[face];
    volume[p] += (mesh.points[a] - origin).dot(area_normal(mesh.points[a], mesh.points[b], mesh.points[c]));
  }
  const auto inside_out = [&](std::size_t p) {
    return topology.component[p].boundary_loops == 0 && topology.component[p].orientable && volume[p] < 0.0;
  };
  // An enclosed component goes with the outermost one around it.
  const std::vector<std::uint32_t> outermost = outermost_around(mesh, topology);
  std::size_t turned = 0;
  for (std::size_t p = 0; p < topology.components; ++p)
    if (inside_out(outermost[p])) ++turned;
  for (FaceIndex face = 0; face < mesh.triangles.size(); ++face)
    if (inside_out(outermost[topology.component_of_face[face]])) turn(mesh.triangles[face]);
  return turned;
}

}  // namespace nanocarbon::mesh
