// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/read_stl.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "nanocarbon/mesh/parsing/byte_order.h"
#include "nanocarbon/mesh/formats/read_mesh.h"
#include "support/refusal.h"

namespace nanocarbon::mesh {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::vector<std::array<Vec3, 3>> two_triangles = {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                                                        {Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(1, 1, 0.5)}};

std::string as_text(const std::string& normal = "0 0 1") {
  std::string text = "solid a thing\n";
  for (const auto& triangle : two_triangles) {
    text += "  facet normal " + normal + "\n    outer loop\n";
    for (const Vec3& p : triangle)
      text += "      vertex " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
              std::to_string(p.z()) + "\n";
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid a thing\n";
}

template <typename Number>
void append(std::string& bytes, Number number) {
  const auto stored = bytes_of(number, ByteOrder::little);
  bytes.append(stored.data(), stored.size());
}

std::string as_binary(std::uint32_t count = 2, std::string header = "", float first = 0.0f) {
  header.resize(80, ' ');
  append(header, count);
  bool is_first = true;
  for (const auto& triangle : two_triangles) {
    for (int i = 0; i < 3; ++i) append(header, std::numeric_limits<float>::quiet_NaN());
    for (const Vec3& p : triangle)
      for (const double x : p) append(header, std::exchange(is_first, false) ? first : static_cast<float>(x));
    append(header, std::uint16_t{7});
  }
  return header;
}

void expect_two_triangles(const PolygonSoup& soup) {
  EXPECT_THAT(soup.points, ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0.5)));
  EXPECT_THAT(soup.corners, ElementsAre(0, 1, 2, 2, 1, 3));
}

std::string refused(const std::string& contents) {
  return test::refusal(Failure::malformed, [&] { parse_mesh(contents, "a.stl"); });
}

//! A tetrahedron, which is closed, with a count that may be wrong.
std::string closed_binary(std::uint32_t count) {
  std::string bytes(80, ' ');
  append(bytes, count);
  const std::array<Vec3, 4> corner = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  for (const auto& face : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) {
    for (int i = 0; i < 3; ++i) append(bytes, 0.0f);
    for (const int v : face)
      for (const double x : corner[v]) append(bytes, static_cast<float>(x));
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

TEST(ReadStl, TextAndBinaryGiveTheSameMeshWithCornersJoined) {
  expect_two_triangles(parse_mesh(as_text(), "a.stl"));
  expect_two_triangles(parse_mesh(as_binary(), "a.stl"));
}

TEST(ReadStl, ABinaryFileMayBeginWithSolid) {
  expect_two_triangles(parse_mesh(as_binary(2, "solid made by a program"), "a.stl"));
  expect_two_triangles(parse_mesh(as_binary(2, "solid x\nfacet normal 0 0 1\nouter loop\n"), "a.stl"));
}

TEST(ReadStl, TheExtensionDoesNotMatter) {
  expect_two_triangles(parse_mesh(as_text(), "a.off"));
  expect_two_triangles(parse_mesh(as_binary(), "noextension"));
}

TEST(ReadStl, NormalsMayBeAnything) {
  expect_two_triangles(parse_mesh(as_text("nan -nan(ind) 1,0"), "a.stl"));
}

TEST(ReadStl, KeywordsInCapitalsAndMissingEndsolid) {
  std::string text = as_text();
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  expect_two_triangles(parse_mesh(text, "a.stl"));
  const PolygonSoup soup = parse_mesh(as_text().substr(0, as_text().find("endsolid")), "a.stl");
  expect_two_triangles(soup);
  EXPECT_THAT(soup.notes, testing::Contains(HasSubstr("endsolid")));
}

// Some programs write a triangle on a line, or all of them, or part words that others write as one.
TEST(ReadStl, LinesDoNotMatter) {
  std::string one_line = as_text(), parted = as_text();
  for (char& c : one_line)
    if (c == '\n') c = ' ';
  expect_two_triangles(parse_mesh(one_line, "a.stl"));
  EXPECT_EQ(parse_mesh(one_line + one_line, "a.stl").faces(), 4u);
  std::string line_each;
  for (std::size_t i = 0; i < one_line.size(); ++i) {
    line_each += one_line[i];
    if (i >= 8 && one_line.substr(i - 8, 9) == "endfacet ") line_each += '\n';
  }
  expect_two_triangles(parse_mesh(line_each, "a.stl"));
  for (const std::string word : {"loop", "facet", "solid"})
    for (std::size_t at = 0; (at = parted.find("end" + word, at)) != parted.npos; at += 4)
      parted.replace(at, 3, "end ");
  expect_two_triangles(parse_mesh(parted, "a.stl"));
  // A corner that is missing is not made up for by the next triangle's.
  std::string short_of_one = one_line;
  short_of_one.erase(
      short_of_one.find("vertex"),
      short_of_one.find("vertex", short_of_one.find("vertex") + 1) - short_of_one.find("vertex"));
  EXPECT_THAT(refused(short_of_one), HasSubstr("expected 'vertex' in triangle 0, found 'endloop'"));
}

TEST(ReadStl, WhatStandsBeforeTheFirstSolidIsPassedOver) {
  for (const std::string before :
       {"# by hand\n", "; exported\n\n", "// one\n// two\n", "Exported by a program\n"})
    expect_two_triangles(parse_mesh(before + as_text(), "a.stl"));
  std::string bare = as_text().substr(as_text().find("facet"));
  expect_two_triangles(parse_mesh(bare.substr(0, bare.find("endsolid")), "a.stl"));
}

// The header's text is that of no byte order, so only a count that is right in the other one tells.
TEST(ReadStl, BigEndianFilesAreRead) {
  std::string bytes = closed_binary(4);
  const auto turn = [&](std::size_t at) {
    std::reverse(bytes.begin() + static_cast<long>(at), bytes.begin() + static_cast<long>(at) + 4);
  };
  turn(80);
  for (std::size_t triangle = 0; triangle < 4; ++triangle)
    for (std::size_t k = 0; k < 12; ++k) turn(84 + 50 * triangle + 4 * k);
  const PolygonSoup turned = parse_mesh(bytes, "a.stl"), plain = parse_mesh(closed_binary(4), "a.stl");
  EXPECT_EQ(turned.points, plain.points);
  EXPECT_EQ(turned.corners, plain.corners);
  EXPECT_THAT(turned.notes, testing::Contains(HasSubstr("big-endian")));
}

TEST(ReadStl, TextThatIsNoStlIsSaidSo) {
  EXPECT_THAT(refused("hello\n"), HasSubstr("a.stl:1: the file is text, but no STL"));
}

TEST(ReadStl, SeveralSolidsAreOneMesh) { EXPECT_EQ(parse_mesh(as_text() + as_text(), "a.stl").faces(), 4u); }

TEST(ReadStl, ZeroAndMinusZeroAreOnePlace) {
  const PolygonSoup soup = parse_mesh(as_binary(2, "", -0.0f), "a.stl");
  EXPECT_EQ(soup.points.size(), 4u);
}

TEST(ReadStl, BytesAfterTheLastTriangleAreTold) {
  const PolygonSoup soup = parse_mesh(as_binary() + "abc", "a.stl");
  expect_two_triangles(soup);
  EXPECT_THAT(soup.notes, testing::Contains(HasSubstr("3 bytes after the last triangle")));
}

TEST(ReadStl, ColoursArePassedOver) {
  std::string text = as_text();
  text.insert(text.find("  facet"), "color 0.5 0.5 0.5\n");
  expect_two_triangles(parse_mesh(text, "a.stl"));
}

TEST(ReadStl, AWrongCountIsRightedByTheLengthOfAFileThatCloses) {
  EXPECT_EQ(parse_mesh(closed_binary(4), "a.stl").notes.size(), 1u);
  for (const std::uint32_t count : {0u, 3u, 5u, 4294967295u}) {
    const PolygonSoup soup = parse_mesh(closed_binary(count), "a.stl");
    EXPECT_EQ(soup.faces(), 4u) << count;
    EXPECT_THAT(soup.notes, testing::Contains(HasSubstr("the file's length says 4"))) << count;
  }
  EXPECT_EQ(parse_mesh(as_binary(0), "a.stl").faces(), 2u);  // open, but none can be meant
  EXPECT_THAT(refused(as_binary(1)), HasSubstr("promises 1 triangles, but the file has room for 2"));
}

TEST(ReadStl, BrokenFilesAreRefusedWithThePlace) {
  EXPECT_THAT(refused(as_binary(3)), HasSubstr("byte 184: the file ends after 2 of 3 triangles"));
  EXPECT_THAT(refused(as_binary(4294967295u)), HasSubstr("the file ends after 2 of 4294967295 triangles"));
  EXPECT_THAT(refused(as_binary().substr(0, 183)), HasSubstr("the file ends after 1 of 2 triangles"));
  EXPECT_THAT(refused(as_binary().substr(0, 40)), HasSubstr("within the header"));
  EXPECT_THAT(refused(as_binary(2, "", std::numeric_limits<float>::infinity())),
              HasSubstr("byte 96: a coordinate of triangle 0 is not finite"));
  EXPECT_THAT(refused(as_text().substr(0, as_text().find("endloop"))),
              HasSubstr("the file ends within triangle 0"));
  EXPECT_THAT(refused("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n"),
              HasSubstr("a.stl:6: expected 'vertex' in triangle 0, found 'endloop'"));
  EXPECT_THAT(refused("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 nan\n"),
              HasSubstr("a.stl:4: the z coordinate"));
  EXPECT_THAT(refused("solid\nhello\n"), HasSubstr("a.stl:2: expected 'facet' or 'endsolid'"));
}

}  // namespace
}  // namespace nanocarbon::mesh
