// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "nanocarbon/mesh/polygon_soup.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::test {

//! A regular tetrahedron with edges of sqrt(8), wound outward: V = 4, E = 6, F = 4, volume 8/3.
inline TriangleMesh tetrahedron(const Vec3& at = Vec3::Zero(), double scale = 1.0) {
  TriangleMesh mesh;
  for (const Vec3& p : {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)})
    mesh.points.push_back(at + scale * p);
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  return mesh;
}

inline mesh::PolygonSoup soup(std::vector<Vec3> points, const std::vector<std::vector<VertexIndex>>& faces) {
  mesh::PolygonSoup result;
  result.points = std::move(points);
  for (const auto& face : faces) {
    result.corners.insert(result.corners.end(), face.begin(), face.end());
    result.close_face();
  }
  return result;
}

//! The unit cube as six squares, wound outward: V = 8, E = 12, F = 6.
inline mesh::PolygonSoup cube(const Vec3& at = Vec3::Zero(), double scale = 1.0) {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i) points.push_back(at + scale * Vec3(i & 1, i >> 1 & 1, i >> 2 & 1));
  return soup(points, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

//! A torus of n times m quads: V = n m, E = 2 n m, F = n m.
inline mesh::PolygonSoup torus(VertexIndex n, VertexIndex m, double major = 3.0, double minor = 1.0) {
  mesh::PolygonSoup result;
  for (VertexIndex i = 0; i < n; ++i)
    for (VertexIndex j = 0; j < m; ++j) {
      const double u = 2 * M_PI * i / n, v = 2 * M_PI * j / m;
      const double r = major + minor * std::cos(v);
      result.points.emplace_back(r * std::cos(u), r * std::sin(u), minor * std::sin(v));
      const VertexIndex i1 = (i + 1) % n, j1 = (j + 1) % m;
      for (const VertexIndex corner : {i * m + j, i1 * m + j, i1 * m + j1, i * m + j1})
        result.corners.push_back(corner);
      result.close_face();
    }
  return result;
}

inline TriangleMesh turned(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

//! Both meshes in one, the second's vertices after the first's.
inline TriangleMesh together(TriangleMesh first, const TriangleMesh& second) {
  const auto shift = static_cast<VertexIndex>(first.points.size());
  first.points.insert(first.points.end(), second.points.begin(), second.points.end());
  for (const auto& [a, b, c] : second.triangles) first.triangles.push_back({a + shift, b + shift, c + shift});
  return first;
}

}  // namespace nanocarbon::test
