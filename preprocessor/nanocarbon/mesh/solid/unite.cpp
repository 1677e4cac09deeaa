// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/solid/unite.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "nanocarbon/core/disjoint_sets.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/join_points.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/self_intersections.h"
#include "nanocarbon/mesh/solid/union_of_solids.h"

namespace nanocarbon::mesh {
namespace {

constexpr const char* instead = "--wrap SIZE puts a closed surface around anything";

[[noreturn]] void refuse(const TriangleMesh& mesh, FaceIndex face, const char* why) {
  const Vec3& at = mesh.points[mesh.triangles[face][0]];
  throw UserError(Failure::unsuitable,
                  fmt::format("--unite: the piece at ({:.6g}, {:.6g}, {:.6g}) overlaps another and {}; {}",
                              at.x(), at.y(), at.z(), why, instead));
}

// Parts that touch in vertices and edges at the same places do not intersect there.
SelfIntersections crossings(TriangleMesh mesh) {
  const CoincidentPoints coincident = coincident_points(mesh.points);
  for (Triangle& triangle : mesh.triangles)
    for (VertexIndex& v : triangle) v = coincident.representative[v];
  return self_intersections(mesh);
}

TriangleMesh faces_of(const TriangleMesh& mesh, const std::vector<FaceIndex>& faces) {
  TriangleMesh part;
  part.points = mesh.points;
  for (const FaceIndex face : faces) part.triangles.push_back(mesh.triangles[face]);
  drop_unused_points(part);
  return part;
}

void append(TriangleMesh& mesh, const TriangleMesh& part) {
  const auto shift = static_cast<VertexIndex>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), part.points.begin(), part.points.end());
  for (const auto& [a, b, c] : part.triangles) mesh.triangles.push_back({a + shift, b + shift, c + shift});
}

// Of a component that is to be united.
TriangleMesh solid_of(const TriangleMesh& mesh, const std::vector<FaceIndex>& faces) {
  TriangleMesh solid = faces_of(mesh, faces);
  if (signed_volume(solid) < 0.0)
    for (Triangle& triangle : solid.triangles) std::swap(triangle[1], triangle[2]);
  return solid;
}

}  // namespace

United unite(const TriangleMesh& mesh) {
  const MeshTopology topology = mesh_topology(mesh);
  const std::vector<std::uint32_t>& component_of = topology.component_of_face;
  const SelfIntersections crossing = crossings(mesh);
  if (!crossing.complete)
    throw UserError(Failure::unsuitable, fmt::format("--unite: too many faces overlap; {}", instead));
  DisjointSets groups(topology.components);
  std::vector<bool> overlaps(topology.components, false);
  for (const auto& [first, second] : crossing.pairs) {
    if (component_of[first] == component_of[second]) continue;
    groups.join(component_of[first], component_of[second]);
    overlaps[component_of[first]] = overlaps[component_of[second]] = true;
  }
  for (std::size_t c = 0; c < topology.components; ++c) {
    const MeshComponent& component = topology.component[c];
    if (!overlaps[c]) continue;
    if (component.boundary_loops > 0) refuse(mesh, component.first_face, "is not closed");
    if (!component.orientable) refuse(mesh, component.first_face, "has no two sides");
  }
  for (const auto& [first, second] : crossing.pairs)
    if (component_of[first] == component_of[second] && overlaps[component_of[first]])
      refuse(mesh, first, "crosses itself there");

  std::vector<std::vector<FaceIndex>> faces(topology.components);
  std::vector<FaceIndex> others;
  for (FaceIndex face = 0; face < mesh.triangles.size(); ++face)
    (overlaps[component_of[face]] ? faces[component_of[face]] : others).push_back(face);
  std::map<std::uint32_t, std::vector<TriangleMesh>> solids;  // by the lowest component of each group
  United united;
  for (std::uint32_t c = 0; c < topology.components; ++c)
    if (overlaps[c]) {
      solids[groups.find(c)].push_back(solid_of(mesh, faces[c]));
      ++united.overlapping;
    }
  united.mesh = faces_of(mesh, others);
  for (const auto& [first, group] : solids) {
    const std::optional<TriangleMesh> one = union_of_solids(group);
    if (!one)
      throw UserError(
          Failure::unsuitable,
          fmt::format("--unite: the union is not a 2-manifold: pieces touch in edges or vertices only; {}",
                      instead));
    append(united.mesh, *one);
    ++united.unions;
  }
  return united;
}

std::string describe(const United& united) {
  if (united.overlapping == 0) return "united nothing: no pieces overlap";
  return fmt::format("united {} overlapping pieces: {} remain{}", united.overlapping, united.unions,
                     united.unions == 1 ? "s" : "");
}

}  // namespace nanocarbon::mesh
