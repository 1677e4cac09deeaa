// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/solid/alpha_wrap.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>
#include <CGAL/version.h>

#include <cstddef>
#include <vector>

#include "nanocarbon/mesh/solid/cgal_version.h"
#include "nanocarbon/mesh/solid/surface_mesh.h"

namespace nanocarbon::mesh {

TriangleMesh alpha_wrap(const TriangleMesh& mesh, double alpha, double offset) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  std::vector<Point> points;
  points.reserve(mesh.points.size());
  for (const Vec3& p : mesh.points) points.emplace_back(p.x(), p.y(), p.z());
  std::vector<std::vector<std::size_t>> faces;
  faces.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) faces.push_back({t[0], t[1], t[2]});
  CGAL::Surface_mesh<Point> wrap;
  CGAL::alpha_wrap_3(points, faces, alpha, offset, wrap);
  return from_surface_mesh(wrap);
}

const char* cgal_version() { return CGAL_VERSION_STR; }

}  // namespace nanocarbon::mesh
