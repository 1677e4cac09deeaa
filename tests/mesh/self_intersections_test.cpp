// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/self_intersections.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "nanocarbon/mesh/triangle_intersection.h"
#include "nanocarbon/mesh/triangulate.h"
#include "support/small_meshes.h"

namespace nanocarbon::mesh {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

// Two triangles without a common vertex.
bool meet(const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& t) {
  TriangleMesh mesh{{s[0], s[1], s[2], t[0], t[1], t[2]}, {{0, 1, 2}, {3, 4, 5}}};
  const bool found = !self_intersections(mesh).pairs.empty();
  std::swap(mesh.triangles[0], mesh.triangles[1]);
  EXPECT_EQ(!self_intersections(mesh).pairs.empty(), found) << "the order matters";
  return found;
}

const std::array<Vec3, 3> flat = {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};

TEST(SelfIntersections, TrianglesWithoutCommonVertices) {
  EXPECT_TRUE(meet(flat, {Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(2, 2, 1)}));      // pierced
  EXPECT_TRUE(meet(flat, {Vec3(-1, 1, -1), Vec3(-1, 1, 1), Vec3(5, 1, 0)}));    // through two sides
  EXPECT_TRUE(meet(flat, {Vec3(1, 1, 0), Vec3(1, 1, 1), Vec3(2, 1, 1)}));       // touched by a vertex
  EXPECT_TRUE(meet(flat, {Vec3(2, -1, 0), Vec3(2, 1, 0), Vec3(2, 0, 1)}));      // touched by a side
  EXPECT_TRUE(meet(flat, {Vec3(1, 1, 0), Vec3(9, 1, 0), Vec3(1, 9, 0)}));       // overlapping in a plane
  EXPECT_TRUE(meet(flat, {Vec3(1, 1, 0), Vec3(1.5, 1, 0), Vec3(1, 1.5, 0)}));   // one within the other
  EXPECT_FALSE(meet(flat, {Vec3(1, 1, 1e-12), Vec3(1, 2, 1), Vec3(2, 1, 1)}));  // just above
  EXPECT_FALSE(meet(flat, {Vec3(3, 3, 0), Vec3(9, 3, 0), Vec3(3, 9, 0)}));      // beside it in its plane
  EXPECT_FALSE(meet(flat, {Vec3(3, 3, -1), Vec3(3, 3, 1), Vec3(4, 4, 1)}));     // through the plane beside it
  EXPECT_FALSE(meet(flat, {Vec3(-1, -1, -1), Vec3(-1, -1, 1), Vec3(-2, 5, 0)}));
}

TEST(SelfIntersections, WhatTheyShareDoesNotCount) {
  EXPECT_THAT(self_intersections(test::tetrahedron()).pairs, IsEmpty());
  EXPECT_THAT(self_intersections(triangulate(test::cube()).mesh).pairs, IsEmpty());
  EXPECT_THAT(self_intersections(triangulate(test::torus(24, 12)).mesh).pairs, IsEmpty());
}

TEST(SelfIntersections, BeyondASharedVertex) {
  // Both have vertex 0; the second goes through the first's far side, or only away from it.
  TriangleMesh mesh{{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0), Vec3(3, 3, -1), Vec3(3, 3, 1)},
                    {{0, 1, 2}, {0, 3, 4}}};
  EXPECT_THAT(self_intersections(mesh).pairs, SizeIs(1));
  mesh.points[3] = Vec3(-3, -3, -1);
  mesh.points[4] = Vec3(-3, -3, 1);
  EXPECT_THAT(self_intersections(mesh).pairs, IsEmpty());
  mesh.points[3] = Vec3(1, 0.5, 0);  // in the same plane, in the same corner
  mesh.points[4] = Vec3(0.5, 1, 0);
  EXPECT_THAT(self_intersections(mesh).pairs, SizeIs(1));
  mesh.points[3] = Vec3(-1, 0.5, 0);  // in the same plane, elsewhere around the vertex
  mesh.points[4] = Vec3(-1, -1, 0);
  EXPECT_THAT(self_intersections(mesh).pairs, IsEmpty());
}

// Triangles in one plane with corners on a lattice, where nothing is rounded.
TEST(SelfIntersections, AroundASharedVertexTheyMeetWhereTheirCornersOverlap) {
  struct Step {
    int x, y;
  };
  std::vector<Step> steps;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      if (x != 0 || y != 0) steps.push_back({x, y});
  const auto turn = [](Step a, Step b) { return a.x * b.y - a.y * b.x; };
  const auto place = [](Step a) { return Vec3(a.x, a.y, a.x + 2 * a.y); };
  int meeting = 0, apart = 0;
  for (const Step a : steps)
    for (const Step b : steps) {
      if (turn(a, b) <= 0 || (a.x + 2 * a.y + b.x) % 3 != 0) continue;
      for (const Step c : steps)
        for (const Step d : steps) {
          if (turn(c, d) <= 0) continue;
          const auto holds = [&](Step p, Step q, Step w) { return turn(p, w) >= 0 && turn(w, q) >= 0; };
          const bool expected = holds(a, b, c) || holds(a, b, d) || holds(c, d, a) || holds(c, d, b);
          TriangleMesh mesh{{place({0, 0}), place(a), place(b), place(c), place(d)}, {{0, 1, 2}, {3, 4, 0}}};
          ASSERT_EQ(intersect(mesh, mesh.triangles[0], mesh.triangles[1]), expected)
              << a.x << a.y << " " << b.x << b.y << " " << c.x << c.y << " " << d.x << d.y;
          (expected ? meeting : apart) += 1;
        }
    }
  EXPECT_GT(meeting, 1000);
  EXPECT_GT(apart, 1000);
}

TEST(SelfIntersections, FoldedFlatAlongASharedEdge) {
  TriangleMesh mesh{{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(1, 2, 0), Vec3(1, 1, 0)}, {{0, 1, 2}, {1, 0, 3}}};
  EXPECT_THAT(self_intersections(mesh).pairs, SizeIs(1));
  mesh.points[3] = Vec3(1, -1, 0);
  EXPECT_THAT(self_intersections(mesh).pairs, IsEmpty());
  mesh.points[3] = Vec3(1, 1, 1e-9);
  EXPECT_THAT(self_intersections(mesh).pairs, IsEmpty());
}

TEST(SelfIntersections, ATwoWayTorusThatIsThickerThanItsHoleMeetsItself) {
  EXPECT_THAT(self_intersections(triangulate(test::torus(24, 12, 3.0, 2.9)).mesh).pairs, IsEmpty());
  EXPECT_FALSE(self_intersections(triangulate(test::torus(24, 12, 3.0, 3.3)).mesh).pairs.empty());
}

TEST(SelfIntersections, TheTreeFindsWhatTryingAllPairsFinds) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(0, 1), offset(-0.1, 0.1);
  TriangleMesh mesh;
  for (VertexIndex t = 0; t < 400; ++t) {
    const Vec3 centre(place(random), place(random), place(random));
    for (int i = 0; i < 3; ++i)
      mesh.points.push_back(centre + Vec3(offset(random), offset(random), offset(random)));
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  std::vector<std::array<std::uint32_t, 2>> expected;
  for (std::uint32_t i = 0; i < 400; ++i)
    for (std::uint32_t j = i + 1; j < 400; ++j)
      if (intersect(mesh, mesh.triangles[i], mesh.triangles[j])) expected.push_back({i, j});
  EXPECT_GT(expected.size(), 20u);
  EXPECT_EQ(self_intersections(mesh).pairs, expected);
}

// A fat ring of the given size, a little crumpled: where a symmetric one meets its image, corners meet edges, and
// rounding decides.
TriangleMesh ring(const Vec3& centre, double radius) {
  TriangleMesh mesh = triangulate(test::torus(20, 12, 0.62, 0.35)).mesh;
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> offset(-0.02, 0.02);
  for (Vec3& p : mesh.points)
    p = centre + radius * (p + Vec3(offset(random), offset(random), offset(random)));
  return mesh;
}

// Cubic, tetragonal in two directions, and skewed, periodic in all and in one.
std::vector<Cell> cells() {
  Cell skewed, rhombohedral;
  skewed.vectors << 1.0, 0.3, -0.2, 0.0, 1.1, 0.45, 0.0, 0.0, 0.9;
  rhombohedral.vectors << 0, 0.7, 0.7, 0.7, 0, 0.7, 0.7, 0.7, 0;
  rhombohedral.vectors.col(0).swap(rhombohedral.vectors.col(1));
  Cell along_one = skewed;
  along_one.periodic = {false, false, true};
  std::vector<Cell> all = {orthogonal_cell({1, 1, 1}), orthogonal_cell({1, 1, 2}, {true, true, false}),
                           skewed, rhombohedral, along_one};
  for (Cell& cell : all) cell.origin = Vec3(0.1, -0.7, 0.3);
  return all;
}

// In free space: the surface and its image in each translation of the cell, one of each two that are opposite.
std::vector<std::array<std::uint32_t, 2>> pairs_with_images(const TriangleMesh& mesh, const Cell& cell) {
  const auto triangles = static_cast<std::uint32_t>(mesh.triangles.size());
  std::vector<std::array<std::uint32_t, 2>> pairs = self_intersections({mesh.points, mesh.triangles}).pairs;
  const auto reach = [&](std::size_t d) { return cell.periodic[d] ? 2 : 0; };
  for (int i = -reach(0); i <= reach(0); ++i)
    for (int j = -reach(1); j <= reach(1); ++j)
      for (int k = -reach(2); k <= reach(2); ++k) {
        if (std::array{i, j, k} <= std::array{0, 0, 0}) continue;
        TriangleMesh image{mesh.points, mesh.triangles};
        for (Vec3& p : image.points) p += image_shift(cell, {i, j, k});
        const TriangleMesh both = test::together({mesh.points, mesh.triangles}, image);
        for (const auto& [a, b] : self_intersections(both).pairs)
          if (a < triangles && b >= triangles)
            pairs.push_back({std::min(a, b - triangles), std::max(a, b - triangles)});
      }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

// A surface may cross its images through a face, an edge or a corner of the cell, wherever it lies in it, and
// whichever image of each vertex is the one that is kept.
TEST(SelfIntersections, InACellASurfaceMeetsTheImagesThatItMeetsInFreeSpace) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> place(0, 1);
  std::uniform_int_distribution<int> anywhere(-2, 2);
  std::size_t found = 0, clear = 0;
  for (const Cell& cell : cells())
    for (const double radius : {0.3, 0.52, 0.6}) {
      const Vec3 centre = cell.origin + cell.vectors * Vec3(place(random), place(random), place(random));
      TriangleMesh mesh = ring(centre, radius);
      const auto expected = pairs_with_images(mesh, cell);
      mesh.space = Space(cell);
      EXPECT_EQ(self_intersections(mesh).pairs, expected) << "radius " << radius;
      for (Vec3& p : mesh.points) {
        std::array<int, 3> image{};
        for (std::size_t d = 0; d < 3; ++d) image[d] = cell.periodic[d] ? anywhere(random) : 0;
        p += image_shift(cell, image);
      }
      EXPECT_EQ(self_intersections(mesh).pairs, expected) << "radius " << radius;
      ++(expected.empty() ? clear : found);
    }
  EXPECT_GE(found, 4u);
  EXPECT_GE(clear, 4u);
}

// Four triangles at one edge, two of each surface: at these angles around it.
SelfIntersections at_an_edge(const std::array<double, 2>& one, const std::array<double, 2>& other,
                             const Cell* cell) {
  TriangleMesh mesh;
  if (cell) mesh.space = Space(*cell);
  for (const auto& angles : {one, other}) {
    const auto first = static_cast<VertexIndex>(mesh.points.size());
    // In a cell each has images of its own.
    const Vec3 shift = cell && first > 0 ? image_shift(*cell, {1, -2, 3}) : Vec3(0, 0, 0);
    mesh.points.insert(mesh.points.end(), {Vec3(0, 0, 0) + shift, Vec3(0, 0, 0.2) + shift});
    for (const double angle : angles)
      mesh.points.push_back(Vec3(0.2 * std::cos(angle), 0.2 * std::sin(angle), 0.1) + shift);
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first + 1, first, first + 3});
  }
  SelfIntersections found = self_intersections(mesh);
  std::vector<VertexIndex> places = {0, 1, 2, 3, 0, 1, 6, 7};
  if (cell) {
    EXPECT_EQ(first_at_place(mesh), places);
    EXPECT_THAT(found.pairs, IsEmpty()) << "they have nothing but the edge in common";
  }
  found = {};
  add_crossings_in_edges(mesh, places, found);
  return found;
}

TEST(SelfIntersections, SurfacesCrossInAnEdgeWhereTheirFacesTakeTurns) {
  const Cell cell = cells()[2];
  for (const Cell* space : {static_cast<const Cell*>(nullptr), &cell})
    for (const double turn : {0.0, 0.7, 2.1, 4.4}) {
      const auto crossing = at_an_edge({turn, turn + 3}, {turn + 1, turn + 5}, space);
      ASSERT_THAT(crossing.pairs, SizeIs(1));
      EXPECT_LT(crossing.pairs[0][0], 2u);
      EXPECT_GE(crossing.pairs[0][1], 2u);
      if (space) {
        ASSERT_EQ(crossing.moved.size(), 1u);
        EXPECT_LT((crossing.moved[0] - image_shift(cell, {1, -2, 3})).norm(), 1e-9);
      }
      EXPECT_THAT(at_an_edge({turn + 5, turn + 1}, {turn, turn + 3}, space).pairs, SizeIs(1));
      EXPECT_THAT(at_an_edge({turn, turn + 1}, {turn + 2, turn + 3}, space).pairs, IsEmpty()) << "they touch";
      EXPECT_THAT(at_an_edge({turn, turn + 3}, {turn + 1, turn + 2}, space).pairs, IsEmpty())
          << "one within the other";
    }
}

TEST(SelfIntersections, AHeapOfTrianglesAtOnePlaceIsGivenUpAndSaidSo) {
  TriangleMesh mesh;
  for (VertexIndex t = 0; t < 3000; ++t) {
    const double angle = 0.001 * t;
    mesh.points.insert(mesh.points.end(), {Vec3(std::cos(angle), std::sin(angle), -1),
                                           Vec3(-std::cos(angle), -std::sin(angle), -1), Vec3(0, 0, 1)});
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  EXPECT_FALSE(self_intersections(mesh).complete);
}

}  // namespace
}  // namespace nanocarbon::mesh
