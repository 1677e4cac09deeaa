// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/scenes/read_3mf.h"

#include <gmock/gmock.h>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/formats/read_mesh.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/triangulate.h"
#include "support/refusal.h"
#include "support/scene_files.h"
#include "support/small_meshes.h"

namespace nanocarbon::mesh {
namespace {

using testing::Contains;
using testing::HasSubstr;

const std::string tetrahedron = "<object id=\"1\">" + test::mesh_3mf(test::tetrahedron()) + "</object>\n";

PolygonSoup parsed(const std::string& resources, const std::string& build, const std::string& unit = "inch") {
  return parse_mesh(test::file_3mf(resources, build, unit), "a.3mf");
}
std::string malformed(const std::string& resources, const std::string& build) {
  return test::refusal(Failure::malformed, [&] { parsed(resources, build); });
}
double volume_of(const PolygonSoup& soup) { return signed_volume(triangulate(soup).mesh); }

TEST(Read3mf, AnItemOfTheBuildIsTheMeshInTheFilesUnit) {
  const PolygonSoup soup = parsed(tetrahedron, "<item objectid=\"1\"/>");
  EXPECT_EQ(soup.points, test::tetrahedron().points);
  EXPECT_EQ(soup.unit, "inch");
  EXPECT_NEAR(volume_of(soup), signed_volume(test::tetrahedron()), 1e-12);
}

// 3MF core specification, 3.3: coordinates are a row that is multiplied with the matrix, whose last row is the
// translation. Components are placed before what contains them is.
TEST(Read3mf, ItemsAndComponentsStandWhereTheyArePlaced) {
  const PolygonSoup soup = parsed(
      tetrahedron +
          "<object id=\"2\"><components><component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 100 0 0\"/>"
          "<component objectid=\"1\"/></components></object>",
      "<item objectid=\"2\" transform=\"0 2 0 -2 0 0 0 0 2 0 0 7\"/>");
  ASSERT_EQ(soup.points.size(), 8u);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 p = test::tetrahedron().points[i];
    // (x + 100, y, z) times the matrix: x to 2 y, y to -2 x.
    EXPECT_NEAR((soup.points[i] - Vec3(-2 * p.y(), 2 * (p.x() + 100), 2 * p.z() + 7)).norm(), 0, 1e-12);
    EXPECT_NEAR((soup.points[i + 4] - Vec3(-2 * p.y(), 2 * p.x(), 2 * p.z() + 7)).norm(), 0, 1e-12);
  }
  EXPECT_NEAR(volume_of(soup), 2 * 8 * signed_volume(test::tetrahedron()), 1e-9);
  EXPECT_THAT(soup.notes, Contains("placed 2 objects as the file says"));
}

TEST(Read3mf, AReflectionDoesNotTurnItInsideOut) {
  const PolygonSoup soup =
      parsed(tetrahedron, "<item objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>");
  EXPECT_NEAR(volume_of(soup), signed_volume(test::tetrahedron()), 1e-12);
}

// The production extension: objects in other parts of the package, as slicers write their projects.
TEST(Read3mf, ObjectsMayBeInOtherParts) {
  const std::string model = "<model xmlns=\"m\" unit=\"millimeter\" xmlns:p=\"q\"><resources>";
  const std::string contents = test::stored_zip(
      {{"3D/3dmodel.model", model + "<object id=\"8\"><components><component p:path=\"/3D/Objects/a.model\" "
                                    "objectid=\"1\"/></components>"
                                    "</object></resources><build><item objectid=\"8\"/></build></model>"},
       {"3D/Objects/a.model", model + tetrahedron + "</resources><build/></model>"}});
  EXPECT_EQ(parse_mesh(contents, "a.3mf").points, test::tetrahedron().points);
}

TEST(Read3mf, WhatIsWrongIsNamedWithItsLine) {
  EXPECT_THAT(malformed(tetrahedron, ""), HasSubstr("a.3mf: 3D/part.model:2: the file builds nothing"));
  EXPECT_THAT(malformed(tetrahedron, "<item objectid=\"3\"/>"), HasSubstr("there is no object '3'"));
  EXPECT_THAT(malformed(tetrahedron, "<item objectid=\"1\" transform=\"1 0 0\"/>"),
              HasSubstr("is not twelve numbers"));
  EXPECT_THAT(malformed(tetrahedron, "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0 0 0\"/>"),
              HasSubstr("is not twelve numbers"));
  EXPECT_THAT(
      malformed(
          "<object id=\"1\"><mesh><vertices><vertex x=\"0\" y=\"1,5\" z=\"0\"/></vertices></mesh></object>",
          "<item objectid=\"1\"/>"),
      HasSubstr("part.model:4: the element 'vertex' has no number in its attribute 'y', but '1,5'"));
  EXPECT_THAT(malformed(test::replaced(tetrahedron, "v1=\"0\"", "v1=\"44\""), "<item objectid=\"1\"/>"),
              HasSubstr("a triangle uses vertex 44, but its object has 4"));
  EXPECT_THAT(malformed("<object id=\"1\"><components><component objectid=\"1\"/></components></object>",
                        "<item objectid=\"1\"/>"),
              HasSubstr("contain each other"));
  std::string bomb = tetrahedron;
  for (int level = 2; level < 40; ++level)
    bomb += "<object id=\"" + std::to_string(level) + "\"><components>" +
            test::replaced("<component objectid=\"N\"/><component objectid=\"N\"/>", "N",
                           std::to_string(level - 1)) +
            "</components></object>";
  EXPECT_THAT(malformed(bomb, "<item objectid=\"39\"/>"), HasSubstr("multiply to more than can be meant"));
  EXPECT_THAT(malformed(tetrahedron + "<object>", "<item objectid=\"1\"/>"),
              HasSubstr("the file is not XML"));
}

TEST(Read3mf, DamagedArchivesAreRefused) {
  const std::string good = test::file_3mf(test::tetrahedron());
  const auto refusal = [&](const std::string& contents) {
    return test::refusal(Failure::malformed, [&] { parse_mesh(contents, "a.3mf"); });
  };
  EXPECT_THAT(refusal(good.substr(0, good.size() - 30)), HasSubstr("directory at the end"));
  EXPECT_THAT(refusal(test::replaced(good, "<vertex x=\"-1\" y=\"1\"", "<vertex x=\"-1\" y=\"8\"")),
              HasSubstr("'3D/part.model' is damaged"));
  EXPECT_THAT(refusal(test::replaced(good, "3D/part.model\" Id", "3D/gone.model\" Id")),
              HasSubstr("damaged"));
  EXPECT_THAT(refusal(test::stored_zip({{"a.txt", "hello"}})), HasSubstr("ZIP archive, but no 3MF file"));
}

}  // namespace
}  // namespace nanocarbon::mesh
