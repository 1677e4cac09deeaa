// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/solid/mend_crossings.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <stdexcept>

#include "nanocarbon/mesh/solid/surface_mesh.h"

namespace nanocarbon::mesh {

std::optional<TriangleMesh> mend_crossings(const TriangleMesh& mesh, const std::vector<FaceIndex>& examined,
                                           Handles handles) {
  namespace processing = CGAL::Polygon_mesh_processing;
  auto surface = to_surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>(mesh);
  std::vector<decltype(surface)::Face_index> faces;
  faces.reserve(examined.size());
  for (const FaceIndex face : examined) faces.emplace_back(face);
  try {
    if (!processing::experimental::remove_self_intersections(
            faces, surface, CGAL::parameters::preserve_genus(handles == Handles::keep)))
      return std::nullopt;
  } catch (const std::logic_error&) {  // its assertions, where these are compiled in
    return std::nullopt;
  }
  return from_surface_mesh(surface);
}

}  // namespace nanocarbon::mesh
