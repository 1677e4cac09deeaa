// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/flip_slivers.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/self_intersections.h"
#include "support/small_meshes.h"

namespace nanocarbon::mesh {
namespace {

std::size_t slivers(const TriangleMesh& mesh) {
  return static_cast<std::size_t>(
      std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                    [&](const Triangle& t) { return has_no_area(mesh.points, t); }));
}

// Two triangles at a common side that is divided differently above and below, with triangles without area in
// between in any arrangement: what CAD programs write. Area 1; a disc.
TriangleMesh mismatched_side(std::size_t above, std::size_t below, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0.01, 0.99);
  TriangleMesh mesh;
  mesh.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 1, 0), Vec3(0.5, -1, 0)};
  const auto divide = [&](std::size_t n) {
    std::vector<double> at(n);
    for (double& x : at) x = uniform(random);
    std::sort(at.begin(), at.end());
    std::vector<VertexIndex> chain = {0};
    for (const double x : at) {
      chain.push_back(static_cast<VertexIndex>(mesh.points.size()));
      mesh.points.emplace_back(x, 0, 0);
    }
    chain.push_back(1);
    return chain;
  };
  const std::vector<VertexIndex> up = divide(above), down = divide(below);
  for (std::size_t i = 0; i + 1 < up.size(); ++i) mesh.triangles.push_back({up[i], up[i + 1], 2});
  for (std::size_t i = 0; i + 1 < down.size(); ++i) mesh.triangles.push_back({down[i + 1], down[i], 3});
  // From one end to the other, always going on above or below.
  std::size_t i = 0, j = 0;
  while (i + 2 < up.size() || j + 2 < down.size()) {
    const bool go_up = j + 2 >= down.size() || (i + 2 < up.size() && random() % 2 == 0);
    const VertexIndex a = up[i], b = down[j];
    const VertexIndex next = go_up ? up[++i] : down[++j];
    if (a == b)  // both chains begin at one vertex: the first step opens the strip
      mesh.triangles.push_back(go_up ? Triangle{a, down[++j], next} : Triangle{a, next, up[++i]});
    else
      mesh.triangles.push_back({a, b, next});
  }
  mesh.triangles.push_back({up[i], down[j], 1});
  return mesh;
}

TEST(FlipSlivers, AnyStripWithoutAreaIsTakenOutAndTheShapeStays) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 300; ++i) {
    TriangleMesh mesh = mismatched_side(1 + random() % 6, 1 + random() % 6, random);
    const MeshTopology before = mesh_topology(mesh);
    ASSERT_TRUE(before.manifold() && before.consistently_wound());
    ASSERT_EQ(before.euler_characteristic, 1);
    ASSERT_GT(slivers(mesh), 0u);
    EXPECT_GT(flip_slivers(mesh), 0u);
    EXPECT_EQ(slivers(mesh), 0u);
    EXPECT_DOUBLE_EQ(area(mesh), 1.0);
    EXPECT_THAT(self_intersections(mesh).pairs, testing::IsEmpty());
    const MeshTopology after = mesh_topology(mesh);
    EXPECT_TRUE(after.manifold() && after.consistently_wound());
    EXPECT_EQ(after.euler_characteristic, 1);
    EXPECT_EQ(after.faces, before.faces);
  }
}

TEST(FlipSlivers, ASoundMeshStaysAsItIs) {
  TriangleMesh mesh = test::tetrahedron();
  EXPECT_EQ(flip_slivers(mesh), 0u);
  EXPECT_EQ(mesh.triangles, test::tetrahedron().triangles);
}

// A tetrahedron pressed flat to a line has nothing to flip to; it must end.
TEST(FlipSlivers, WhatCannotBeRemovedStays) {
  TriangleMesh mesh = test::tetrahedron();
  for (int i = 0; i < 4; ++i) mesh.points[static_cast<std::size_t>(i)] = Vec3(i, 0, 0);
  flip_slivers(mesh);
  EXPECT_EQ(slivers(mesh), 4u);
}

}  // namespace
}  // namespace nanocarbon::mesh
