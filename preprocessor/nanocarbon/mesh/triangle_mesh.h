// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "nanocarbon/core/space.h"
#include "nanocarbon/core/vec3.h"

namespace nanocarbon {

using VertexIndex = std::uint32_t;
using Triangle = std::array<VertexIndex, 3>;

//! An indexed triangle mesh as plain data: the user's surface, a triangulation at rest, an example shape. In a
//! periodic space its points stand for all their images; no edge is longer than a third of the least width.
//! Triangles are wound counter-clockwise seen from outside. What is wrong with a mesh: mesh/diagnosis.h.
struct TriangleMesh {
  std::vector<Vec3> points;  //!< mesh units, or Angstrom once scaled
  std::vector<Triangle> triangles;
  Space space = {};  //!< that the points lie in: what is between two of them is a displacement in it
};

//! The corners of a triangle side by side: the first where it is, the images of the others beside it.
inline std::array<Vec3, 3> corners_of(const TriangleMesh& mesh, const Triangle& triangle) {
  const Vec3& a = mesh.points[triangle[0]];
  return {a, mesh.space.beside(mesh.points[triangle[1]], a), mesh.space.beside(mesh.points[triangle[2]], a)};
}

//! The same with the first corner wrapped into the cell: what trees of boxes are made of.
inline std::array<Vec3, 3> corners_in_cell(const TriangleMesh& mesh, const Triangle& triangle) {
  const Vec3 a = mesh.space.wrapped(mesh.points[triangle[0]]);
  return {a, mesh.space.beside(mesh.points[triangle[1]], a), mesh.space.beside(mesh.points[triangle[2]], a)};
}

//! Multiplies all lengths of a mesh and of its space by a factor above zero.
inline void rescale(TriangleMesh& mesh, double factor) {
  for (Vec3& point : mesh.points) point *= factor;
  mesh.space = mesh.space.scaled(factor);
}

}  // namespace nanocarbon
