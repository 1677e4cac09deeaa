// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/solid/union_of_solids.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>

#include "nanocarbon/mesh/solid/surface_mesh.h"

namespace nanocarbon::mesh {
namespace {

using SurfaceMesh = CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>;

SurfaceMesh to_surface_mesh(const TriangleMesh& from) {
  SurfaceMesh mesh;
  std::vector<SurfaceMesh::Vertex_index> vertices;
  vertices.reserve(from.points.size());
  for (const Vec3& p : from.points) vertices.push_back(mesh.add_vertex({p.x(), p.y(), p.z()}));
  for (const Triangle& t : from.triangles) mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  return mesh;
}

}  // namespace

std::optional<TriangleMesh> union_of_solids(const std::vector<TriangleMesh>& solids) {
  SurfaceMesh united;
  for (const TriangleMesh& solid : solids) {
    SurfaceMesh next = to_surface_mesh(solid);
    if (united.is_empty())
      united = std::move(next);
    else if (!CGAL::Polygon_mesh_processing::corefine_and_compute_union(united, next, united))
      return std::nullopt;
  }
  return from_surface_mesh(united);
}

}  // namespace nanocarbon::mesh
