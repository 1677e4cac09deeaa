// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/read_off.h"

#include <gmock/gmock.h>

#include <array>
#include <cstdint>

#include "nanocarbon/mesh/formats/read_mesh.h"
#include "nanocarbon/mesh/parsing/byte_order.h"
#include "support/refusal.h"

namespace nanocarbon::mesh {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string tetrahedron = "4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

void expect_tetrahedron(const std::string& contents) {
  const PolygonSoup soup = parse_mesh(contents, "a.off");
  EXPECT_THAT(soup.points, ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)));
  EXPECT_THAT(soup.corners, ElementsAre(0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3));
  EXPECT_THAT(soup.notes, testing::IsEmpty());
}

std::string with_line_ends(const std::string& text, const std::string& line_end) {
  std::string result;
  for (const char c : text) result += c == '\n' ? line_end : std::string(1, c);
  return result;
}

std::string refused(const std::string& contents) {
  return test::refusal(Failure::malformed, [&] { parse_mesh(contents, "a.off"); });
}

TEST(ReadOff, AFaceWithoutAnyVertices) {
  EXPECT_THAT(refused("OFF\n0 1 0\n3 0 1 2\n"), testing::HasSubstr("there are 0 vertices"));
}

TEST(ReadOff, PlainFileInEveryLayoutInUse) {
  expect_tetrahedron("OFF\n" + tetrahedron);
  expect_tetrahedron("OFF " + tetrahedron);  // counts on the header's line
  expect_tetrahedron("OFF" + tetrahedron);   // as in the ModelNet collection
  expect_tetrahedron(tetrahedron);           // the header is optional
  expect_tetrahedron("off\n" + tetrahedron);
  expect_tetrahedron("# made by hand\n\nOFF # header\n# counts\n" + tetrahedron);
  expect_tetrahedron("\xEF\xBB\xBFOFF\n" + tetrahedron);
  expect_tetrahedron(with_line_ends("OFF\n" + tetrahedron, "\r\n"));
  expect_tetrahedron(with_line_ends("OFF\n" + tetrahedron, "\r"));
  expect_tetrahedron(with_line_ends("OFF\n" + tetrahedron, "\n\n \t\n"));
  expect_tetrahedron("OFF\n" + tetrahedron.substr(0, tetrahedron.size() - 1));  // no last line end
}

// Geomview reads numbers, whatever lines they are on.
TEST(ReadOff, NumbersMayStandOnAnyLine) {
  const std::string vertices = "0 0 0 1 0 0 0 1 0 0 0 1", faces = "3 0 2 1 3 0 1 3 3 1 2 3 3 2 0 3";
  for (const std::string edges : {" 6", ""}) {
    const std::string numbers = "4 4" + edges + " " + vertices + " " + faces + "\n";
    expect_tetrahedron("OFF " + numbers);
    expect_tetrahedron("OFF\n4 4" + edges + "\n" + vertices + "\n" + faces + "\n");
    expect_tetrahedron("OFF\n4 4" + edges + "\n0 0 0 1 0 0\n0 1 0 0 0 1\n3 0 2 1 3 0 1 3\n3 1 2 3 3 2 0 3\n");
    std::string lines = numbers;
    for (char& c : lines)
      if (c == ' ') c = '\n';
    expect_tetrahedron("OFF\n" + lines);
  }
  // But all of them belong to vertices and faces, and the message is that of the lines.
  EXPECT_THAT(refused("OFF\n4 4 6 " + vertices + " " + faces + " 9\n"),
              HasSubstr("ends after 0 of 4 vertices"));
  EXPECT_THAT(refused("OFF\n4 4 6\n" + vertices + "\n3 0 2 1 3 0 1 4 3 1 2 3 3 2 0 3\n"),
              HasSubstr("the file ends"));
}

TEST(ReadOff, ColoursNormalsAndTextureCoordinatesArePassedOver) {
  // In Geomview's order and in MeshLab's.
  for (const std::string header : {"COFF", "NOFF", "STOFF", "CNOFF", "STCNOFF", "NCOFF", "NCSTOFF"}) {
    const PolygonSoup soup = parse_mesh(
        header + "\n3 1 0\n1 2 3 .5 .5 .5 1\n4 5 6 0 0 0 1\n7 8 9 0 0 0 1\n3 0 1 2 255 0 0\n", "a.off");
    EXPECT_THAT(soup.points, ElementsAre(Vec3(1, 2, 3), Vec3(4, 5, 6), Vec3(7, 8, 9))) << header;
    EXPECT_THAT(soup.corners, ElementsAre(0, 1, 2));
  }
}

TEST(ReadOff, CoordinatesAreExactDoubles) {
  const PolygonSoup soup = parse_mesh(
      "OFF\n3 1 0\n0.1 +1e-3 -0.30000000000000004\n1e-400 4.9e-324 0\n1E5 .5 5.\n3 0 1 2\n", "a.off");
  EXPECT_EQ(soup.points[0], Vec3(0.1, 1e-3, -0.1 - 0.2));
  EXPECT_EQ(soup.points[1], Vec3(0.0, 4.9e-324, 0.0));
  EXPECT_EQ(soup.points[2], Vec3(1e5, 0.5, 5.0));
}

TEST(ReadOff, WhatFollowsTheLastFaceIsPassedOverAndTold) {
  const PolygonSoup soup = parse_mesh("OFF\n" + tetrahedron + "3 0 1 2\n", "a.off");
  EXPECT_EQ(soup.faces(), 4u);
  EXPECT_THAT(soup.notes, ElementsAre(HasSubstr("line 11")));
}

TEST(ReadOff, AFaceMayBeWrappedOverLines) {
  expect_tetrahedron("OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3\n0 2 1\n3 0\n1\n\n3\n3 1 2 3\n3 2 0 3\n");
  // A face with a corner too few is not made whole by the next one's numbers.
  EXPECT_THAT(refused("OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2\n3 0 1 3\n"),
              HasSubstr("a.off:8: face 0 has fewer than 3 corners on its own line"));
}

TEST(ReadOff, BrokenFilesAreRefusedWithTheLine) {
  EXPECT_THAT(refused(""), HasSubstr("empty"));
  EXPECT_THAT(refused("OFF"), HasSubstr("a.off:1: the file ends before the counts"));
  EXPECT_THAT(refused("OFF\n3"), HasSubstr("a.off:2: the number of faces is missing"));
  EXPECT_THAT(refused("OFF\n-3 1 0\n"), HasSubstr("a.off:2: the number of vertices is negative"));
  EXPECT_THAT(refused("OFF\n3.5 1 0\n"), HasSubstr("'3.5' is not an integer"));
  EXPECT_THAT(refused("OFF\n3 1 0\n0 0 0\n1 0"), HasSubstr("a.off:4: the z coordinate is missing"));
  EXPECT_THAT(refused("OFF\n3 1 0\n0 0 0\n"), HasSubstr("a.off:3: the file ends after 1 of 3 vertices"));
  EXPECT_THAT(refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n"), HasSubstr("the file ends after 0 of 1 faces"));
  EXPECT_THAT(refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1"),
              HasSubstr("a.off:6: face 0 lists 2 of 3 corners"));
  EXPECT_THAT(refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
              HasSubstr("vertex 3, but there are 3 vertices, counted from 0"));
  EXPECT_THAT(refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"),
              HasSubstr("a.off:6: the vertex number is negative"));
  EXPECT_THAT(refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n"),
              HasSubstr("a.off:6: face 0 has 2 corners"));
}

TEST(ReadOff, NumbersThatAreNoneAreRefused) {
  const auto with = [](const std::string& x) { return "OFF\n3 1 0\n" + x + " 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"; };
  for (const std::string x :
       {"nan", "inf", "-inf", "NaN", "1e400", "1e51", "0x10", "1.0.0", "abc", "1-", "--1", "+-1"})
    EXPECT_THAT(refused(with(x)), HasSubstr("a.off:3: the x coordinate '" + x + "'"));
  EXPECT_THAT(refused(with("0,5")), HasSubstr("decimal points"));
  EXPECT_THAT(refused(with("1" + std::string(400, '0'))), HasSubstr("too large"));
  EXPECT_THAT(refused(with(std::string("1\0", 2))), HasSubstr("'1?' is not a number"));
}

TEST(ReadOff, PromisedCountsAreNotBelieved) {
  EXPECT_THAT(refused("OFF\n4000000000 4000000000 0\n0 0 0\n"),
              HasSubstr("ends after 1 of 4000000000 vertices"));
  EXPECT_THAT(refused("OFF\n9223372036854775807 9 0\n0 0 0\n"),
              HasSubstr("ends after 1 of 9223372036854775807"));
  EXPECT_THAT(refused("OFF\n99999999999999999999 9 0\n"), HasSubstr("is not an integer"));
  EXPECT_THAT(refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n"),
              HasSubstr("lists 3 of 4000000000"));
}

//! The tetrahedron as a binary file, with so many further numbers for each vertex.
std::string binary(const std::string& header, ByteOrder order, std::size_t extra = 0) {
  std::string bytes = header + "\n";
  const auto add = [&](auto value) {
    for (const char byte : bytes_of(value, order)) bytes += byte;
  };
  const auto whole = [&](int value) { add(static_cast<std::int32_t>(value)); };
  for (const int count : {4, 4, 6}) whole(count);
  for (int v = 0; v < 4; ++v) {
    for (int d = 1; d <= 3; ++d) add(v == d ? 1.0f : 0.0f);
    for (std::size_t k = 0; k < extra; ++k) add(0.5f);
  }
  int colours = 0;  // of the faces: none, one, two and three numbers
  for (const std::array<int, 3>& face : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
    whole(3);
    for (const int corner : face) whole(corner);
    whole(colours);
    for (int k = 0; k < colours; ++k) add(0.25f);
    ++colours;
  }
  return bytes;
}

TEST(ReadOff, BinaryFilesOfAllKindsOfVertices) {
  expect_tetrahedron(binary("OFF BINARY", ByteOrder::big));
  expect_tetrahedron("# made by hand\n" + binary("OFF BINARY", ByteOrder::big));
  expect_tetrahedron(binary("NOFF BINARY", ByteOrder::big, 3));
  expect_tetrahedron(binary("COFF BINARY", ByteOrder::big, 4));
  expect_tetrahedron(binary("STOFF BINARY", ByteOrder::big, 2));
  expect_tetrahedron(binary("STCNOFF BINARY", ByteOrder::big, 9));
}

TEST(ReadOff, BinaryFilesInTheOtherByteOrderAndWithMoreAreTold) {
  EXPECT_THAT(parse_mesh(binary("OFF BINARY", ByteOrder::little), "a.off").notes,
              ElementsAre(HasSubstr("little-endian")));
  EXPECT_THAT(parse_mesh(binary("OFF BINARY", ByteOrder::big) + "more", "a.off").notes,
              ElementsAre(HasSubstr("4 bytes")));
}

TEST(ReadOff, BrokenBinaryFilesAreRefusedWithTheByte) {
  const std::string whole = binary("OFF BINARY", ByteOrder::big);
  for (std::size_t length = 11; length < whole.size(); ++length)
    EXPECT_THAT(refused(whole.substr(0, length)), HasSubstr("the file ends within the ")) << length;
  const auto with = [&](std::size_t at, const std::string& bytes) {
    std::string broken = whole;
    return refused(broken.replace(at, bytes.size(), bytes));
  };
  const std::size_t vertices = 11 + 12, faces = vertices + 48;
  EXPECT_THAT(with(11, "\x7f\xff\xff\xff"), HasSubstr("the file ends within"));  // promised vertices
  EXPECT_THAT(with(vertices + 4, "\x7f\xc0"), HasSubstr("byte 23: a coordinate of vertex 0 is not finite"));
  EXPECT_THAT(with(faces + 3, "\2"), HasSubstr("face 0 has 2 corners"));
  EXPECT_THAT(with(faces, "\x7f"), HasSubstr("the file ends within"));  // promised corners
  EXPECT_THAT(with(faces + 7, "\4"), HasSubstr("face 0 uses vertex 4, but there are 4"));
  EXPECT_THAT(with(faces + 16, "\x7f"), HasSubstr("the file ends within"));  // promised colours
}

TEST(ReadOff, WhatIsNotSupportedIsSaidSo) {
  EXPECT_THAT(refused("4OFF\n3 1 0\n"), HasSubstr("four or n dimensions"));
  EXPECT_THAT(refused("nOFF\n3 3 1 0\n"), HasSubstr("four or n dimensions"));
}

}  // namespace
}  // namespace nanocarbon::mesh
