// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/low_pass_filter.h"

#include <gmock/gmock.h>

#include <random>

#include "remeshing/shapes.h"

namespace nanocarbon::thesis {
namespace {

VertexStars stars_of(const TriangleMesh& mesh) { return vertex_stars(to_triangulation(mesh)); }

//! Whether a vertex's stars up to the second hold no boundary vertex: then the lattice around it is whole.
bool deep_inside(const VertexStars& stars, VertexIndex v) {
  RingSearch search(stars);
  for (const VertexIndex w : search.search({&v, 1}, 1))
    if (stars.on_boundary[w]) return false;
  return true;
}

TEST(LowPassFilter, LeavesARegularLatticeWhereItIsAlsoFarFromTheOrigin) {
  TriangleMesh lattice = test::equilateral_sheet(1.4, 10, 10);
  for (Vec3& p : lattice.points) p += Vec3(1e3, -2e3, 5e2);
  for (const unsigned rings : {1u, 2u}) {
    VertexStars stars = stars_of(lattice);
    low_pass_filter(stars, rings);
    for (VertexIndex v = 0; v < stars.vertices(); ++v)
      if (rings == 1 || (rings == 2 && deep_inside(stars, v))) {
        EXPECT_TRUE(stars.points[v].isApprox(lattice.points[v], 1e-12)) << rings << " rings, vertex " << v;
      }
  }
}

TEST(LowPassFilter, BoundariesStayAndAFlatSheetStaysFlat) {
  TriangleMesh sheet = test::sheet(3.0, 2.0, 9, 6);
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(-0.1, 0.1);
  for (Vec3& p : sheet.points) p += Vec3(uniform(random), uniform(random), 0.0);
  VertexStars stars = stars_of(sheet);
  const LowPassResult result = low_pass_filter(stars, 2);
  EXPECT_GT(result.mean_move, 0.0);
  EXPECT_GE(result.max_move, result.mean_move);
  for (VertexIndex v = 0; v < stars.vertices(); ++v) {
    EXPECT_DOUBLE_EQ(stars.points[v].z(), 0.0);
    EXPECT_TRUE(!stars.on_boundary[v] || stars.points[v] == sheet.points[v]);
  }
}

TEST(LowPassFilter, MovesAreTangential) {
  const TriangleMesh torus = test::torus(3.0, 1.0, 20, 10);
  const VertexStars before = stars_of(torus);
  VertexStars after = before;
  low_pass_filter(after, 2);
  double longest = 0.0;
  for (std::size_t v = 0; v < before.vertices(); ++v) {
    const Vec3 move = after.points[v] - before.points[v];
    longest = std::max(longest, move.norm());
    EXPECT_NEAR(move.dot(vertex_normal(before, v)), 0.0, 1e-12);
  }
  EXPECT_GT(longest, 1e-3);
}

// A hexagon's centre moved off: with one ring it goes to the mean of its six neighbours, the centre.
TEST(LowPassFilter, OneRingIsTheMeanOfTheNeighbours) {
  TriangleMesh hexagon;
  for (int k = 0; k < 6; ++k)
    hexagon.points.emplace_back(std::cos(k * M_PI / 3), std::sin(k * M_PI / 3), 0.0);
  hexagon.points.emplace_back(0.3, -0.2, 0.0);
  for (VertexIndex k = 0; k < 6; ++k) hexagon.triangles.push_back({6, k, (k + 1) % 6});
  VertexStars stars = stars_of(hexagon);
  low_pass_filter(stars, 1);
  EXPECT_NEAR(stars.points[6].norm(), 0.0, 1e-15);
}

// Ring r weighs 1/r: counted here by another search for the rings.
TEST(LowPassFilter, TheSecondRingWeighsHalf) {
  const TriangleMesh mesh = test::sphere(1.0, 2);
  const VertexStars before = stars_of(mesh);
  VertexStars after = before;
  low_pass_filter(after, 2);
  for (const VertexIndex v : {0u, 20u, 101u}) {
    std::vector<int> ring(before.vertices(), 9);
    ring[v] = 0;
    for (int r = 0; r < 2; ++r)
      for (const Triangle& t : mesh.triangles)
        for (int k = 0; k < 3; ++k)
          if (ring[t[k]] == r)
            for (const VertexIndex w : t) ring[w] = std::min(ring[w], r + 1);
    Vec3 sum = Vec3::Zero();
    double weights = 0.0;
    for (VertexIndex w = 0; w < before.vertices(); ++w)
      if (ring[w] == 1 || ring[w] == 2) {
        sum += before.points[w] / ring[w];
        weights += 1.0 / ring[w];
      }
    Vec3 move = sum / weights - before.points[v];
    const Vec3 n = vertex_normal(before, v);
    move -= move.dot(n) * n;
    EXPECT_TRUE((after.points[v] - before.points[v]).isApprox(move, 1e-9) || move.norm() < 1e-12);
  }
}

}  // namespace
}  // namespace nanocarbon::thesis
