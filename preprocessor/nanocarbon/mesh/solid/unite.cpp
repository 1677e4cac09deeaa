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
#include "nanocarbon/mesh/nearest_point.h"
#include "nanocarbon/mesh/self_intersections.h"
#include "nanocarbon/mesh/solid/mesh_parts.h"
#include "nanocarbon/mesh/solid/union_of_solids.h"
#include "nanocarbon/mesh/triangle_intersection.h"
#include "nanocarbon/mesh/triangle_tree.h"

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

// Whether a point is inside of a closed mesh: where a ray from it goes through the mesh an odd number of times. Not where it
// lies on the mesh.
bool is_inside(const TriangleMesh& solid, const TriangleTree& tree, const NearestPoint& surface,
               const Vec3& point) {
  const double diagonal = tree.nodes[0].box.diagonal();
  if (surface.nearest(point).distance < 1e-9 * diagonal) return false;
  for (int attempt = 0; attempt < 10; ++attempt) {
    const Vec3 to =
        point + 2.0 * diagonal * Vec3(0.5 + 0.1 * attempt, 0.3183, 0.7712 - 0.13 * attempt).normalized();
    std::size_t crossed = 0;
    bool degenerate = false;
    visit_triangles(
        tree, [&](const BoundingBox& box) { return meets_segment(box, point, to); },
        [&](std::uint32_t t) {
          const auto [a, b, c] = corners_of(solid, solid.triangles[t]);
          const Crossing found = crossing(point, to, a, b, c);
          crossed += found == Crossing::through;
          degenerate = degenerate || found == Crossing::degenerate;
        });
    if (!degenerate) return crossed % 2 == 1;
  }
  return false;
}

// Whether faces of one solid that begin at vertices of another go on inside of it, and others outside.
bool goes_in_and_out(const TriangleMesh& one, const TriangleMesh& solid, const std::vector<bool>& is_shared) {
  const TriangleTree tree = triangle_tree(solid);
  const NearestPoint surface(solid);
  bool in = false, out = false;
  for (const Triangle& t : one.triangles) {
    if (!is_shared[t[0]] && !is_shared[t[1]] && !is_shared[t[2]]) continue;
    const auto [a, b, c] = corners_of(one, t);
    (is_inside(solid, tree, surface, (a + b + c) / 3) ? in : out) = true;
    if (in && out) return true;
  }
  return false;
}

// Pairs of closed components that have vertices at the same places, and cross there: that is no intersection for
// crossings(), where their edges or vertices lie on each other.
std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing_at_vertices(const TriangleMesh& mesh,
                                                                          const MeshTopology& topology,
                                                                          DisjointSets& known) {
  const CoincidentPoints coincident = coincident_points(mesh.points);
  if (coincident.duplicates == 0) return {};
  constexpr auto none = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> component_of_point(mesh.points.size(), none);
  for (FaceIndex face = 0; face < mesh.triangles.size(); ++face)
    for (const VertexIndex v : mesh.triangles[face]) component_of_point[v] = topology.component_of_face[face];
  std::map<VertexIndex, std::vector<VertexIndex>> places;  // with several points
  for (VertexIndex v = 0; v < mesh.points.size(); ++v)
    if (coincident.representative[v] != v) places[coincident.representative[v]].push_back(v);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<VertexIndex>>
      shared;  // by pairs of components
  for (auto& [first, others] : places) {
    others.push_back(first);
    for (const VertexIndex a : others)
      for (const VertexIndex b : others) {
        const std::uint32_t one = component_of_point[a], other = component_of_point[b];
        if (one >= other || other == none || known.find(one) == known.find(other) ||
            topology.component[one].boundary_loops + topology.component[other].boundary_loops > 0)
          continue;
        std::vector<VertexIndex>& points = shared[{one, other}];
        points.insert(points.end(), {a, b});
      }
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing;
  for (const auto& [pair, points] : shared) {
    std::vector<bool> is_shared(mesh.points.size(), false);
    for (const VertexIndex v : points) is_shared[v] = true;
    const auto part = [&](std::uint32_t component) {
      TriangleMesh result{mesh.points, {}};
      for (FaceIndex face = 0; face < mesh.triangles.size(); ++face)
        if (topology.component_of_face[face] == component) result.triangles.push_back(mesh.triangles[face]);
      return result;
    };
    const TriangleMesh one = part(pair.first), other = part(pair.second);
    if (goes_in_and_out(one, other, is_shared) || goes_in_and_out(other, one, is_shared))
      crossing.push_back(pair);
  }
  return crossing;
}

// Of a component that is to be united.
TriangleMesh solid_of(const TriangleMesh& mesh, const std::vector<FaceIndex>& faces) {
  TriangleMesh solid = part_of(mesh, faces);
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
  for (const auto& [first, second] : crossing_at_vertices(mesh, topology, groups)) {
    groups.join(first, second);
    overlaps[first] = overlaps[second] = true;
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
  united.mesh = part_of(mesh, others);
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
