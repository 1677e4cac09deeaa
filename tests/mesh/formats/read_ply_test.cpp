// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/read_ply.h"

#include <gmock/gmock.h>

#include <limits>

#include "nanocarbon/mesh/parsing/byte_order.h"
#include "nanocarbon/mesh/formats/read_mesh.h"
#include "support/refusal.h"

namespace nanocarbon::mesh {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string refused(const std::string& contents) {
  return test::refusal(Failure::malformed, [&] { parse_mesh(contents, "a.ply"); });
}

const std::string text_header =
    "ply\nformat ascii 1.0\ncomment by hand\nobj_info none\nelement vertex 3\nproperty float x\nproperty "
    "float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string text_body = "1 2 3\n4 5 6\n7 8 9\n3 0 2 1\n";

void expect_triangle(const PolygonSoup& soup) {
  EXPECT_THAT(soup.points, ElementsAre(Vec3(1, 2, 3), Vec3(4, 5, 6), Vec3(7, 8, 9)));
  EXPECT_THAT(soup.corners, ElementsAre(0, 2, 1));
}

TEST(ReadPly, Text) {
  expect_triangle(parse_mesh(text_header + text_body, "a.ply"));
  std::string windows;
  for (const char c : text_header + text_body) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expect_triangle(parse_mesh(windows, "a.ply"));
  std::string mac = text_header + text_body;
  std::replace(mac.begin(), mac.end(), '\n', '\r');
  expect_triangle(parse_mesh(mac, "a.ply"));
}

TEST(ReadPly, PropertiesInAnyOrderAndElementsOfAnyKind) {
  expect_triangle(parse_mesh(
      "ply\nformat ascii 1.0\nelement material 2\nproperty float shine\nproperty list int float weights\n"
      "element face 1\nproperty uchar red\nproperty list uint uint vertex_index\nproperty list uchar float "
      "texcoord\n"
      "element nothing 1000000000000\n"
      "element vertex 3\nproperty double z\nproperty uchar red\nproperty int16 y\nproperty float32 "
      "x\nproperty float quality\n"
      "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n"
      "0.5 2 0.5 0.5\n0.1 0\n255 3 0 2 1 2 0.5 0.5\n3 9 2 1 nan\n6 9 5 4 0\n9 9 8 7 0\n0 1\n",
      "a.ply"));
}

TEST(ReadPly, ListsOf64Bits) {
  for (const std::string type : {"int64", "uint64"}) {
    std::string header = text_header;
    header.replace(header.find("uchar int"), 9, "uint8 " + type);
    expect_triangle(parse_mesh(header + text_body, "a.ply"));
  }
}

TEST(ReadPly, TriangleStrips) {
  const auto strips = [](const std::string& body) {
    return parse_mesh(
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
        "0 0 0\n2 0 0\n0 2 0\n0 0 2\n" +
            body,
        "a.ply");
  };
  // Every second triangle is turned, and -1 begins a new strip.
  EXPECT_THAT(strips("8 0 1 2 3 -1 0 3 1\n").corners, ElementsAre(0, 1, 2, 2, 1, 3, 0, 3, 1));
  // A repeated vertex only joins stretches.
  EXPECT_THAT(strips("7 0 1 2 2 2 1 3\n").corners, ElementsAre(0, 1, 2, 2, 1, 3));
  EXPECT_EQ(strips("2 0 1\n").faces(), 0u);
  EXPECT_THAT(test::refusal(Failure::malformed, [&] { strips("3 0 1 -2\n"); }),
              HasSubstr("vertex number -2"));
  EXPECT_THAT(test::refusal(Failure::malformed, [&] { strips("3 0 1 7\n"); }), HasSubstr("vertex 7"));
}

TEST(ReadPly, MoreValuesThanAnnouncedArePassedOverWhereEveryLineHasThem) {
  const PolygonSoup soup =
      parse_mesh(text_header + "1 2 3 0 0 1\n4 5 6 0 0 1\n7 8 9 0 0 1\n3 0 2 1 255\n", "a.ply");
  expect_triangle(soup);
  EXPECT_THAT(soup.notes, ElementsAre(HasSubstr("3 value(s) on each line of element 'vertex'"),
                                      HasSubstr("1 value(s) on each line of element 'face'")));
  EXPECT_THAT(refused(text_header + "1 2 3 0\n4 5 6\n7 8 9 0\n3 0 2 1\n"), HasSubstr("a.ply:13: "));
}

TEST(ReadPly, ValuesMayGoOnOnTheNextLine) {
  expect_triangle(parse_mesh(text_header + "1 2\n3\n4 5 6\n7 8 9\n3 0\n2 1\n", "a.ply"));
  // But a value that is missing is not made up by the next line's.
  EXPECT_THAT(refused(text_header + "1 2\n4 5 6\n7 8 9\n3 0 2 1\n"), HasSubstr("more values"));
}

// The values in the order of a header, in the given byte order.
class Binary {
 public:
  explicit Binary(ByteOrder order) : order_(order) {}
  template <typename Number>
  Binary& operator<<(Number number) {
    const auto stored = bytes_of(number, order_);
    bytes_.append(stored.data(), stored.size());
    return *this;
  }
  std::string bytes() const { return bytes_; }

 private:
  ByteOrder order_;
  std::string bytes_;
};

std::string binary_header(ByteOrder order, const std::string& line_end = "\n") {
  const std::string text =
      std::string("ply\nformat binary_") + (order == ByteOrder::little ? "little" : "big") +
      "_endian 1.0\nelement vertex 3\nproperty uchar flag\nproperty double x\nproperty float y\n"
      "property short z\nelement face 1\nproperty list uchar ushort vertex_indices\n"
      "property list ushort double extra\nend_header\n";
  std::string result;
  for (const char c : text) result += c == '\n' ? line_end : std::string(1, c);
  return result;
}

std::string binary_body(ByteOrder order, std::uint8_t corners = 3, std::uint16_t extra = 2) {
  Binary body(order);
  for (int i = 0; i < 3; ++i)
    body << std::uint8_t{10} << double(1 + 3 * i) << float(2 + 3 * i) << std::int16_t(3 + 3 * i);
  body << corners << std::uint16_t{0} << std::uint16_t{2} << std::uint16_t{1} << extra << 0.5 << 0.5;
  return body.bytes();
}

TEST(ReadPly, BinaryOfBothByteOrders) {
  for (const ByteOrder order : {ByteOrder::little, ByteOrder::big})
    for (const std::string line_end : {"\n", "\r\n", "\r"}) {
      const PolygonSoup soup = parse_mesh(binary_header(order, line_end) + binary_body(order), "a.ply");
      expect_triangle(soup);
      EXPECT_THAT(soup.notes, testing::IsEmpty());
    }
}

TEST(ReadPly, AListOfDoublesMayHoldVertexNumbersButOnlyWhole) {
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list double double vertex_indices\nend_header\n";
  const auto with = [&](double corners, double last) {
    Binary body(ByteOrder::little);
    for (int i = 1; i < 10; ++i) body << float(i);
    body << corners << 0.0 << 2.0 << last;
    return header + body.bytes();
  };
  expect_triangle(parse_mesh(with(3.0, 1.0), "a.ply"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.5, -1.0, 1e30, nan})
    EXPECT_THAT(refused(with(3.0, bad)), HasSubstr("vertex number"));
  for (const double bad : {2.5, -1.0, 1e30, nan})
    EXPECT_THAT(refused(with(bad, 1.0)), HasSubstr("a list of length"));
}

TEST(ReadPly, EveryTruncationOfABinaryFileIsRefused) {
  const std::string whole = binary_header(ByteOrder::little) + binary_body(ByteOrder::little);
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_THROW(parse_mesh(whole.substr(0, size), "a.ply"), UserError) << size;
  EXPECT_THAT(parse_mesh(whole + "x", "a.ply").notes, ElementsAre(HasSubstr("after the last element")));
}

TEST(ReadPly, PromisedListLengthsAreNotBelieved) {
  for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
    EXPECT_THAT(refused(binary_header(order) + binary_body(order, 3, 65535)),
                HasSubstr("ends after 0 of 1 elements 'face'"));
    EXPECT_THAT(refused(binary_header(order) + binary_body(order, 255)),
                HasSubstr("ends after 0 of 1 elements 'face'"));
  }
  std::string header = text_header;
  header.replace(header.find("vertex 3"), 8, "vertex 9000000000000000000");
  EXPECT_THAT(refused(header + text_body), HasSubstr("a.ply:15: "));  // the face is no fourth vertex
}

TEST(ReadPly, BrokenTextFilesAreRefusedWithTheLine) {
  EXPECT_THAT(refused(text_header + "1 2 3\n4 5\n"), HasSubstr("a.ply:13: the coordinate is missing"));
  EXPECT_THAT(refused(text_header + "1 2 3\n4 5 6 7\n"), HasSubstr("a.ply:13: the line has more values"));
  EXPECT_THAT(refused(text_header + "1 2 3\n4 5 inf\n"),
              HasSubstr("a.ply:13: the coordinate 'inf' is not finite"));
  EXPECT_THAT(refused(text_header + "1 2 3\n4 5 6\n7 8 9\n3 0 1\n"),
              HasSubstr("a.ply:15: the integer is missing"));
  EXPECT_THAT(refused(text_header + "1 2 3\n4 5 6\n7 8 9\n3 0 1 1.5\n"), HasSubstr("is not an integer"));
  EXPECT_THAT(refused(text_header + "1 2 3\n4 5 6\n7 8 9\n3 0 1 -1\n"),
              HasSubstr("a.ply:15: vertex number -1"));
  EXPECT_THAT(refused(text_header + "1 2 3\n4 5 6\n7 8 9\n3 0 1 3\n"), HasSubstr("face 0 uses vertex 3"));
  EXPECT_THAT(refused(text_header + "1 2 3\n4 5 6\n7 8 9\n2 0 1\n"), HasSubstr("face 0 has 2 corners"));
  EXPECT_THAT(refused(text_header + "1 2 3\n4 5 6\n"), HasSubstr("ends after 2 of 3 elements 'vertex'"));
}

TEST(ReadPly, BrokenHeadersAreRefusedWithTheLine) {
  EXPECT_THAT(refused("ply\nformat ascii 1.0\n"), HasSubstr("ends before end_header"));
  EXPECT_THAT(refused("ply\nend_header\n"), HasSubstr("no 'format' line"));
  EXPECT_THAT(refused("ply\nformat ascii 2.0\nend_header\n"), HasSubstr("a.ply:2: PLY version '2.0'"));
  EXPECT_THAT(refused("ply\nformat text 1.0\nend_header\n"),
              HasSubstr("a.ply:2: 'text' is not a PLY format"));
  EXPECT_THAT(refused("ply\nformat ascii 1.0\nproperty float x\nend_header\n"),
              HasSubstr("before the first element"));
  EXPECT_THAT(refused("ply\nformat ascii 1.0\nelement vertex -1\nend_header\n"),
              HasSubstr("a.ply:3: the number of elements"));
  EXPECT_THAT(refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\nend_header\n"),
              HasSubstr("'real'"));
  EXPECT_THAT(refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty float\nend_header\n"),
              HasSubstr("no name"));
  EXPECT_THAT(refused("ply\nformat ascii 1.0\nhello\nend_header\n"), HasSubstr("a.ply:3: 'hello'"));
  EXPECT_THAT(refused("ply\nformat ascii 1.0\nend_header\n"), HasSubstr("no element 'vertex'"));
  EXPECT_THAT(refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n"),
              HasSubstr("no property y"));
}

}  // namespace
}  // namespace nanocarbon::mesh
