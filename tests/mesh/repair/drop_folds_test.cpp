// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/drop_folds.h"

#include <gtest/gtest.h>

#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/repair/repair_surface.h"
#include "nanocarbon/mesh/triangulate.h"
#include "support/small_meshes.h"

namespace nanocarbon::mesh {
namespace {

void add(PolygonSoup& soup, const std::vector<VertexIndex>& face) {
  soup.corners.insert(soup.corners.end(), face.begin(), face.end());
  soup.close_face();
}

TEST(DropFolds, AFinOfTwoSidesGoes) {
  PolygonSoup soup = soup_of(test::tetrahedron());
  soup.points.emplace_back(9, 0, 0);
  add(soup, {0, 1, 4});
  add(soup, {1, 0, 4});
  EXPECT_EQ(drop_folds(soup).of_fins, 2u);
  EXPECT_EQ(soup.faces(), 4u);
}

TEST(DropFolds, ASheetGivenForBothSidesBecomesOne) {
  PolygonSoup soup;
  for (int i = 0; i < 9; ++i) soup.points.emplace_back(i % 3, i / 3, 0);
  for (const VertexIndex v : {0u, 1u, 3u, 4u}) add(soup, {v, v + 1, v + 4, v + 3});
  for (const VertexIndex v : {0u, 1u, 3u, 4u}) add(soup, {v + 3, v + 4, v + 1, v});
  EXPECT_EQ(drop_folds(soup).of_sheets, 4u);
  EXPECT_EQ(soup.faces(), 4u);
  EXPECT_GT(newell_normal(soup.points, soup.face(0)).z(), 0.0);  // the side that came first
}

TEST(DropFolds, SolidsThatShareAWallBecomeOne) {
  PolygonSoup soup = test::cube();
  const PolygonSoup other = test::cube(Vec3(1, 0, 0));
  for (std::size_t face = 0; face < other.faces(); ++face) {
    for (const VertexIndex v : other.face(face)) soup.corners.push_back(v + 8);
    soup.close_face();
  }
  soup.points.insert(soup.points.end(), other.points.begin(), other.points.end());
  const RepairedSurface repaired = repair_surface(soup);
  EXPECT_TRUE(repaired.diagnosis.usable());
  EXPECT_EQ(repaired.diagnosis.topology.components, 1u);
  EXPECT_DOUBLE_EQ(repaired.diagnosis.area, 10.0);
  EXPECT_DOUBLE_EQ(repaired.diagnosis.volume.value_or(0), 2.0);
}

TEST(DropFolds, WhatIsUnclearStays) {
  PolygonSoup soup = soup_of(test::tetrahedron());
  add(soup, {0, 2, 1});  // the second side of one face of a closed surface
  const DroppedFolds dropped = drop_folds(soup);
  EXPECT_EQ(dropped.of_fins, 0u);
  EXPECT_EQ(soup.faces() + dropped.of_sheets, 5u);
}

}  // namespace
}  // namespace nanocarbon::mesh
