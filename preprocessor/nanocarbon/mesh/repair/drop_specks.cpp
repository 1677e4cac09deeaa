// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/drop_specks.h"

#include <utility>

#include "nanocarbon/core/disjoint_sets.h"
#include "nanocarbon/mesh/join_points.h"
#include "nanocarbon/mesh/measures.h"

namespace nanocarbon::mesh {
namespace {

struct Components {
  std::vector<std::uint32_t> of_face;
  std::vector<double> areas;
};

Components components_of(const TriangleMesh& mesh) {
  DisjointSets vertices(mesh.points.size());
  for (const Triangle& t : mesh.triangles) {
    vertices.join(t[0], t[1]);
    vertices.join(t[0], t[2]);
  }
  constexpr std::uint32_t unknown = std::uint32_t(-1);
  std::vector<std::uint32_t> component(mesh.points.size(), unknown);
  Components components;
  for (const Triangle& t : mesh.triangles) {
    std::uint32_t& name = component[vertices.find(t[0])];
    if (name == unknown) {
      name = static_cast<std::uint32_t>(components.areas.size());
      components.areas.push_back(0.0);
    }
    components.of_face.push_back(name);
    const auto [a, b, c] = corners_in_cell(mesh, t);
    components.areas[name] += 0.5 * area_normal(a, b, c).norm();
  }
  return components;
}

}  // namespace

std::vector<double> component_areas(const TriangleMesh& mesh) { return components_of(mesh).areas; }

std::size_t drop_specks(TriangleMesh& mesh, double least_area) {
  const Components components = components_of(mesh);
  std::size_t dropped = 0;
  for (const double area : components.areas) dropped += area < least_area;
  if (dropped == 0) return 0;
  PolygonSoup kept;
  kept.points = std::move(mesh.points);
  for (FaceIndex face = 0; face < mesh.triangles.size(); ++face) {
    if (components.areas[components.of_face[face]] < least_area) continue;
    kept.corners.insert(kept.corners.end(), mesh.triangles[face].begin(), mesh.triangles[face].end());
    kept.close_face();
  }
  drop_unused_points(kept);
  mesh.points = std::move(kept.points);
  mesh.triangles.resize(kept.faces());
  for (std::size_t corner = 0; corner < kept.corners.size(); ++corner)
    mesh.triangles[corner / 3][corner % 3] = kept.corners[corner];
  return dropped;
}

}  // namespace nanocarbon::mesh
