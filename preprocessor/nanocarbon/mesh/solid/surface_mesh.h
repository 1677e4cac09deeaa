// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! CGAL's mesh as ours, coordinates rounded to doubles; points and triangles keep their order.
template <class Point>
TriangleMesh from_surface_mesh(const CGAL::Surface_mesh<Point>& from) {
  TriangleMesh mesh;
  std::vector<VertexIndex> number(from.number_of_vertices() + from.number_of_removed_vertices());
  mesh.points.reserve(from.number_of_vertices());
  for (const auto v : from.vertices()) {
    const Point& p = from.point(v);
    number[static_cast<std::size_t>(v)] = static_cast<VertexIndex>(mesh.points.size());
    mesh.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }
  mesh.triangles.reserve(from.number_of_faces());
  for (const auto f : from.faces()) {
    Triangle& triangle = mesh.triangles.emplace_back();
    auto corner = from.halfedge(f);
    for (VertexIndex& v : triangle) {
      v = number[static_cast<std::size_t>(from.target(corner))];
      corner = from.next(corner);
    }
  }
  return mesh;
}

}  // namespace nanocarbon::mesh
