// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/read_obj.h"

#include <gmock/gmock.h>

#include "nanocarbon/mesh/formats/read_mesh.h"
#include "support/refusal.h"

namespace nanocarbon::mesh {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string refused(const std::string& contents) {
  return test::refusal(Failure::malformed, [&] { parse_mesh(contents, "a.obj"); });
}

const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

TEST(ReadObj, EveryKindOfCorner) {
  for (const std::string face : {"f 1 3 2 4", "f 1/7 3/8 2/9 4/1", "f 1//1 3//1 2//1 4//1",
                                 "f 1// 3//1 2/ 4/1/", "f 1/1/1 3/2/1 2/3/1 4/4/1", "f -4 -2 -3 -1",
                                 "f -4/-1 -2/-1/-1 2 4", "f\t1  3\\\n 2 \\\r\n4 # a quad", "fo 1 3 2 4"})
    EXPECT_THAT(parse_mesh(points + face + "\n", "a.obj").corners, ElementsAre(0, 2, 1, 3)) << face;
}

TEST(ReadObj, NegativeNumbersCountFromTheLastVertexSoFar) {
  const PolygonSoup soup =
      parse_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -3 -2 -1\n", "a.obj");
  EXPECT_THAT(soup.corners, ElementsAre(0, 1, 2, 1, 2, 3));
}

TEST(ReadObj, FacesMayComeBeforeTheirVertices) {
  EXPECT_THAT(parse_mesh("f 1 2 3\n" + points, "a.obj").corners, ElementsAre(0, 1, 2));
}

TEST(ReadObj, EverythingElseOfTheFormatIsPassedOver) {
  const PolygonSoup soup = parse_mesh(
      "# comment\nmtllib a.mtl\no thing\ng a b\ns off\nusemtl x\nv 0 0 0 1.0\nv 1 0 0 0.5 0.5 0.5\nv 0 1 "
      "0\nvt 0 0\nvn 0 0 nan\n"
      "l 1 2\np 3\nf 1 2 3\n",
      "a.obj");
  EXPECT_EQ(soup.points.size(), 3u);
  EXPECT_EQ(soup.faces(), 1u);
  EXPECT_THAT(soup.notes, testing::IsEmpty());
}

TEST(ReadObj, UnknownLinesAreTold) {
  EXPECT_THAT(
      parse_mesh(points + "f 1 2 3\ncurv 0 1 1 2\nwhatever\ncurv 0 1 1 2\n", "a.obj").notes,
      ElementsAre(HasSubstr("2 line(s) of the kind 'curv'"), HasSubstr("1 line(s) of the kind 'whatever'")));
}

TEST(ReadObj, BrokenFilesAreRefusedWithTheLine) {
  EXPECT_THAT(refused(points + "f 1 2 5\n"),
              HasSubstr("a.obj:5: a face uses vertex 5, but there are 4 vertices"));
  EXPECT_THAT(refused(points + "f 1 2 0\n"),
              HasSubstr("a.obj:5: a face uses vertex 0, but OBJ files number from 1"));
  EXPECT_THAT(refused(points + "f 1 2 -5\n"),
              HasSubstr("a.obj:5: a face uses vertex -5, but only 4 come before it"));
  EXPECT_THAT(refused(points + "f 1 2\n"), HasSubstr("a.obj:5: face 0 has 2 corners"));
  EXPECT_THAT(refused(points + "f\n"), HasSubstr("face 0 has 0 corners"));
  EXPECT_THAT(refused(points + "f 1 \\\n2\n\nf 1 2 x\n"), HasSubstr("a.obj:5: face 0 has 2 corners"));
  EXPECT_THAT(refused(points + "\nf 1 \\\n2 3\nf 1 2 x\n"), HasSubstr("a.obj:8: 'x' is not a face's corner"));
  for (const std::string corner : {"/1", "1/2/3/4", "1///", "1/x", "1.5", "1///2", "99999999999999999999"})
    EXPECT_THAT(refused(points + "f 1 2 " + corner + "\n"), HasSubstr("is not a face's corner")) << corner;
  EXPECT_THAT(refused(points + "f 1 2 4294967297\n"), HasSubstr("uses vertex 4294967297"));
  EXPECT_THAT(refused("v 0 0\n"), HasSubstr("a.obj:1: the z coordinate is missing"));
  EXPECT_THAT(refused("v 0 0 nan\n"), HasSubstr("a.obj:1: the z coordinate 'nan' is not finite"));
}

}  // namespace
}  // namespace nanocarbon::mesh
