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

//! Our mesh as CGAL's; points and triangles keep their order.
//! \pre manifold and consistently wound
template <class Point>
CGAL::Surface_mesh<Point> to_surface_mesh(const TriangleMesh& from) {
  CGAL::Surface_mesh<Point> mesh;
  std::vector<typename CGAL::Surface_mesh<Point>::Vertex_index> vertices;
  vertices.reserve(from.points.size());
  for (const Vec3& p : from.points) vertices.push_back(mesh.add_vertex({p.x(), p.y(), p.z()}));
  for (const Triangle& t : from.triangles) mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  return mesh;
}

}  // namespace nanocarbon::mesh
