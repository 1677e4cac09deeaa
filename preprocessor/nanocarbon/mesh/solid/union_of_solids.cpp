// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/solid/union_of_solids.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>

#include "nanocarbon/mesh/solid/surface_mesh.h"

namespace nanocarbon::mesh {
std::optional<TriangleMesh> union_of_solids(const std::vector<TriangleMesh>& solids) {
  using Point = CGAL::Exact_predicates_exact_constructions_kernel::Point_3;
  CGAL::Surface_mesh<Point> united;
  for (const TriangleMesh& solid : solids) {
    auto next = to_surface_mesh<Point>(solid);
    if (united.is_empty())
      united = std::move(next);
    else if (!CGAL::Polygon_mesh_processing::corefine_and_compute_union(united, next, united))
      return std::nullopt;
  }
  return from_surface_mesh(united);
}

}  // namespace nanocarbon::mesh
