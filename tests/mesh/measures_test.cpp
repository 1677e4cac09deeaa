// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/measures.h"

#include <gmock/gmock.h>

#include <cmath>

#include "nanocarbon/mesh/triangulate.h"
#include "support/small_meshes.h"

namespace nanocarbon::mesh {
namespace {

TEST(Measures, AreThoseOfTheUnitCube) {
  const TriangleMesh cube = triangulate(test::cube(Vec3(1e6, -1e6, 1e6))).mesh;
  EXPECT_DOUBLE_EQ(area(cube), 6.0);
  EXPECT_DOUBLE_EQ(signed_volume(cube), 1.0);
  EXPECT_DOUBLE_EQ(signed_volume(test::turned(cube)), -1.0);
  EXPECT_EQ(bounding_box(cube.points).extent(), Vec3(1, 1, 1));
  const EdgeLengths edges = edge_lengths(test::cube().points, edge_table(test::cube()));
  EXPECT_EQ(edges.edges, 12u);
  EXPECT_DOUBLE_EQ(edges.mean, 1.0);
  EXPECT_DOUBLE_EQ(edges.standard_deviation, 0.0);
  const EdgeLengths with_diagonals = edge_lengths(cube);  // 12 edges of 1 and 6 of sqrt(2)
  EXPECT_NEAR(with_diagonals.mean, (12 + 6 * std::sqrt(2.0)) / 18, 1e-12);
  EXPECT_NEAR(with_diagonals.standard_deviation, (std::sqrt(2.0) - 1) * std::sqrt(2.0) / 3, 1e-12);
  EXPECT_NEAR(with_diagonals.max, std::sqrt(2.0), 1e-12);
}

TEST(Measures, AnEmptyBoxHasNoExtent) {
  EXPECT_TRUE(bounding_box({}).empty());
  EXPECT_EQ(bounding_box({}).longest_side(), 0.0);
}

}  // namespace
}  // namespace nanocarbon::mesh
