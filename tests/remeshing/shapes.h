// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::test {

//! A regular icosahedron of the given circumradius, wound outwards.
inline TriangleMesh icosahedron(double radius) {
  const double g = std::numbers::phi;
  TriangleMesh mesh{{{-1, g, 0},
                     {1, g, 0},
                     {-1, -g, 0},
                     {1, -g, 0},
                     {0, -1, g},
                     {0, 1, g},
                     {0, -1, -g},
                     {0, 1, -g},
                     {g, 0, -1},
                     {g, 0, 1},
                     {-g, 0, -1},
                     {-g, 0, 1}},
                    {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  for (Vec3& p : mesh.points) p *= radius / p.norm();
  return mesh;
}

//! Every triangle split into four by the middles of its edges; the middles go through `place`.
template <class Place>
TriangleMesh subdivided(const TriangleMesh& mesh, Place&& place) {
  TriangleMesh fine;
  fine.points = mesh.points;
  std::map<std::array<VertexIndex, 2>, VertexIndex> middles;
  const auto middle = [&](VertexIndex a, VertexIndex b) {
    const auto [at, is_new] = middles.try_emplace({std::min(a, b), std::max(a, b)}, fine.points.size());
    if (is_new) fine.points.push_back(place(Vec3(0.5 * (mesh.points[a] + mesh.points[b]))));
    return at->second;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const VertexIndex ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.triangles.insert(fine.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return fine;
}

//! A sphere of 20 * 4^levels triangles.
inline TriangleMesh sphere(double radius, int levels) {
  TriangleMesh mesh = icosahedron(radius);
  for (int l = 0; l < levels; ++l)
    mesh = subdivided(mesh, [&](const Vec3& p) { return Vec3(radius / p.norm() * p); });
  return mesh;
}

//! A grid of 2 * columns * rows triangles on a parameter square; `wrap` joins its sides.
template <class Place>
TriangleMesh grid(int columns, int rows, std::array<bool, 2> wrap, Place&& place) {
  TriangleMesh mesh;
  const int nu = wrap[0] ? columns : columns + 1, nv = wrap[1] ? rows : rows + 1;
  for (int j = 0; j < nv; ++j)
    for (int i = 0; i < nu; ++i) mesh.points.push_back(place(double(i) / columns, double(j) / rows));
  const auto at = [&](int i, int j) { return static_cast<VertexIndex>((j % nv) * nu + i % nu); };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

inline TriangleMesh torus(double major, double minor, int columns, int rows) {
  return grid(columns, rows, {true, true}, [&](double u, double v) {
    const double a = 2 * std::numbers::pi * u, b = 2 * std::numbers::pi * v, r = major + minor * std::cos(b);
    return Vec3(r * std::cos(a), r * std::sin(a), minor * std::sin(b));
  });
}

//! A tube open at both ends.
inline TriangleMesh open_tube(double radius, double length, int columns, int rows) {
  return grid(columns, rows, {true, false}, [&](double u, double v) {
    const double a = 2 * std::numbers::pi * u;
    return Vec3(radius * std::cos(a), radius * std::sin(a), length * v);
  });
}

//! A flat rectangle in the xy plane.
inline TriangleMesh sheet(double width, double height, int columns, int rows) {
  return grid(columns, rows, {false, false},
              [&](double u, double v) { return Vec3(width * u, height * v, 0.0); });
}

//! A flat lattice of equilateral triangles in the xy plane.
inline TriangleMesh equilateral_sheet(double edge, int columns, int rows) {
  return grid(columns, rows, {false, false}, [&](double u, double v) {
    return Vec3(edge * (u * columns - 0.5 * v * rows), edge * std::sqrt(0.75) * v * rows, 0.0);
  });
}

//! The shape scaled so that this many equilateral triangles, with the edge that bonds of 1.2 to 1.8 Angstrom
//! ask for, have its area.
inline TriangleMesh sized(TriangleMesh mesh, double triangles) {
  const double scale = std::sqrt(triangles * 0.75 * std::numbers::sqrt3 * 1.5 * 1.5 / mesh::area(mesh));
  for (Vec3& p : mesh.points) p *= scale;
  return mesh;
}

}  // namespace nanocarbon::test
