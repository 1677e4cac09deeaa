// SPDX-License-Identifier: GPL-2.0-or-later
// Triangulations without a defect of tubes and sheets in a periodic cell.
#include "nanocarbon/remeshing/crystal/hexagonal_tori.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nanocarbon/mesh/distance.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/nearest_point.h"
#include "nanocarbon/mesh/periodic_mesh.h"
#include "remeshing/shapes.h"

namespace nanocarbon::crystal {
namespace {

constexpr double pi = std::numbers::pi;

// A tube along z whose radius may change along it.
TriangleMesh periodic_tube(double radius, double length, double bulge, int columns, int rows) {
  TriangleMesh mesh = test::grid(columns, rows, {true, true}, [&](double u, double v) {
    const double a = 2 * pi * u, r = radius + bulge * std::cos(2 * pi * v);
    return Vec3(r * std::cos(a), r * std::sin(a), length * v);
  });
  mesh.space = Space(orthogonal_cell(Vec3(100, 100, length), {false, false, true}));
  return mesh;
}

TriangleMesh periodic_sheet(double width, double height, double ripple, int columns, int rows) {
  TriangleMesh mesh = test::grid(columns, rows, {true, true}, [&](double u, double v) {
    return Vec3(width * u, height * v, ripple * std::sin(2 * pi * u) * std::cos(2 * pi * v));
  });
  mesh.space = Space(orthogonal_cell(Vec3(width, height, 50), {true, true, false}));
  return mesh;
}

void expect_crystal(const TriangleMesh& surface, std::size_t faces, double longest_over_shortest) {
  const auto made = hexagonal_triangulation(surface, faces);
  ASSERT_TRUE(made);
  EXPECT_NEAR(static_cast<double>(made->triangles.size()), static_cast<double>(faces),
              0.03 * static_cast<double>(faces));
  std::vector<int> valence(made->points.size(), 0);
  for (const Triangle& t : made->triangles)
    for (const VertexIndex v : t) ++valence[v];
  for (const int n : valence) EXPECT_EQ(n, 6);
  const mesh::MeshTopology topology = mesh::mesh_topology(*made), wanted = mesh::mesh_topology(surface);
  EXPECT_TRUE(topology.manifold());
  EXPECT_TRUE(topology.orientable && topology.consistently_wound());
  EXPECT_EQ(topology.components, wanted.components);
  EXPECT_EQ(topology.euler_characteristic, 0);
  EXPECT_EQ(mesh::wrapping_ranks(*made, topology), mesh::wrapping_ranks(surface, wanted));
  EXPECT_LT(mesh::distances_to_surface(made->points, mesh::NearestPoint(surface)).max, 1e-9);
  const mesh::EdgeLengths edges = mesh::edge_lengths(*made);
  EXPECT_LT(edges.max / edges.min, longest_over_shortest);
  // Wound as the surface is: its normals lie along those of the nearest triangles.
  const mesh::NearestPoint nearest(surface);
  for (const Triangle& t : made->triangles) {
    const auto [a, b, c] = corners_of(*made, t);
    const mesh::SurfacePoint foot = nearest.nearest((a + b + c) / 3);
    const auto [p, q, r] = corners_of(surface, surface.triangles[foot.triangle]);
    EXPECT_GT(mesh::area_normal(a, b, c).dot(mesh::area_normal(p, q, r)), 0);
  }
}

TEST(HexagonalTriangulation, OfATubeIsARolledSheet) {
  // That of the (10, 10) tube: all bonds alike, so all edges.
  expect_crystal(periodic_tube(6.782, 24.60, 0, 60, 30), 400, 1.03);
  expect_crystal(periodic_tube(6.782, 24.60, 0, 16, 8), 400, 1.15);  // a coarse mesh of the same
  expect_crystal(periodic_tube(3.0, 41.0, 0, 60, 200), 300, 1.15);
}

TEST(HexagonalTriangulation, OfSheetsFlatAndRippled) {
  expect_crystal(periodic_sheet(24.6, 42.608, 0, 10, 20), 400, 1.01);  // 10 by 10 rectangles of four
  expect_crystal(periodic_sheet(33, 33, 0, 10, 10), 416, 1.12);
  expect_crystal(periodic_sheet(40, 50, 3, 40, 50), 790, 1.45);
}

TEST(HexagonalTriangulation, OfATubeWithABulgeAndOfATorus) {
  expect_crystal(periodic_tube(7, 40, 1.2, 60, 60), 670, 1.6);
  expect_crystal(test::torus(40, 5, 200, 40), 3000, 1.7);
}

TEST(HexagonalTriangulation, OfSeveralPieces) {
  TriangleMesh both = periodic_tube(10, 24.60, 0, 60, 30);
  const TriangleMesh inner = periodic_tube(6.782, 24.60, 0, 60, 30);
  const auto first = static_cast<VertexIndex>(both.points.size());
  both.points.insert(both.points.end(), inner.points.begin(), inner.points.end());
  for (const Triangle& t : inner.triangles)
    both.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  expect_crystal(both, 990, 1.15);
}

TEST(HexagonalTriangulation, IsThereForNothingElse) {
  EXPECT_FALSE(hexagonal_triangulation(test::sphere(10, 3), 500));
  EXPECT_FALSE(hexagonal_triangulation(test::open_tube(7, 20, 40, 20), 300));
  EXPECT_FALSE(hexagonal_triangulation(periodic_tube(6.782, 24.60, 0, 60, 30), 8))
      << "too narrow for a lattice";
}

}  // namespace
}  // namespace nanocarbon::crystal
