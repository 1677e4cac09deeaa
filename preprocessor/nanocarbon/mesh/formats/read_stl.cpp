// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/read_stl.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/formats/byte_order.h"
#include "nanocarbon/mesh/formats/text_scanner.h"
#include "nanocarbon/mesh/join_points.h"

namespace nanocarbon::mesh {
namespace {

constexpr std::size_t header_bytes = 84;    // free text (80), number of triangles (4)
constexpr std::size_t triangle_bytes = 50;  // normal (12), corners (36), attribute (2)

bool same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

class TextStlReader {
 public:
  TextStlReader(std::string_view text, const std::string& file) : scanner_(text, file, {'\0', false}) {}

  PolygonSoup read() {
    bool open = false;
    while (scanner_.next_line()) {
      const std::string_view word = scanner_.word();
      if (same_word(word, "solid"))
        open = true;
      else if (same_word(word, "endsolid"))
        open = false;
      else if (same_word(word, "facet") && open)
        read_facet();
      else if (same_word(word, "color") || same_word(word, "colour"))
        continue;
      else
        scanner_.fail(fmt::format("expected 'facet' or 'endsolid', found {}", quoted(word)));
    }
    if (open) soup_.notes.push_back("the last line, 'endsolid', is missing");
    return std::move(soup_);
  }

 private:
  void read_facet() {  // the normal, which ends the line, may be anything
    expect("outer");
    for (int corner = 0; corner < 3; ++corner) {
      expect("vertex");
      const double x = scanner_.coordinate("x coordinate");
      const double y = scanner_.coordinate("y coordinate");
      const double z = scanner_.coordinate("z coordinate");
      soup_.corners.push_back(static_cast<VertexIndex>(soup_.points.size()));
      soup_.points.emplace_back(x, y, z);
    }
    expect("endloop");
    expect("endfacet");
    soup_.close_face();
  }

  void expect(std::string_view keyword) {
    if (!scanner_.next_line()) scanner_.fail(fmt::format("the file ends within triangle {}", soup_.faces()));
    const std::string_view word = scanner_.word();
    if (!same_word(word, keyword))
      scanner_.fail(
          fmt::format("expected '{}' in triangle {}, found {}", keyword, soup_.faces(), quoted(word)));
  }

  TextScanner scanner_;
  PolygonSoup soup_;
};

bool is_closed(const PolygonSoup& soup) {
  PolygonSoup joined = soup;
  join(joined, coincident_points(joined.points));
  const EdgeTable edges = edge_table(joined);
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (edges.uses_of(e).size() == 1) return false;
  return edges.size() > 0;
}

PolygonSoup read_binary(std::string_view contents, const std::string& file) {
  const auto fail = [&](std::size_t byte, const std::string& what) {
    throw UserError(Failure::malformed,
                    fmt::format("{}: byte {}: {}; repair the file or export it again", file, byte, what));
  };
  if (contents.size() < header_bytes)
    fail(contents.size(), "the file ends within the header of a binary STL");
  const std::size_t promised = load<std::uint32_t>(contents.data() + 80, ByteOrder::little);
  const std::size_t present = (contents.size() - header_bytes) / triangle_bytes;
  const bool whole = (contents.size() - header_bytes) % triangle_bytes == 0;
  const auto cut_short = [&] {
    fail(contents.size(), fmt::format("the file ends after {} of {} triangles", present, promised));
  };
  if (promised > present && !whole) cut_short();
  // A program that streams a file may leave the count at zero or at a guess; the length tells better, where
  // it is that of whole triangles and they close.
  const bool count_is_wrong = whole && promised != present;
  const std::size_t triangles = count_is_wrong ? present : promised;

  PolygonSoup soup;
  soup.points.reserve(3 * triangles);
  soup.corners.reserve(3 * triangles);
  soup.offsets.reserve(triangles + 1);
  for (std::size_t triangle = 0; triangle < triangles; ++triangle) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Vec3 point;
      for (std::size_t d = 0; d < 3; ++d) {
        const std::size_t byte = header_bytes + triangle * triangle_bytes + 12 * (corner + 1) + 4 * d;
        point[static_cast<int>(d)] = load<float>(contents.data() + byte, ByteOrder::little);
        if (const char* fault = coordinate_fault(point[static_cast<int>(d)]))
          fail(byte, fmt::format("a coordinate of triangle {} {}", triangle, fault));
      }
      soup.corners.push_back(static_cast<VertexIndex>(soup.points.size()));
      soup.points.push_back(point);
    }
    soup.close_face();
  }
  if (count_is_wrong) {
    if (promised > present && !is_closed(soup)) cut_short();
    if (promised > 0 && !is_closed(soup))
      fail(80,
           fmt::format("the header promises {} triangles, but the file has room for {}", promised, present));
    soup.notes.push_back(
        fmt::format("the header promises {} triangles; the file's length says {}, and these were read",
                    promised, present));
  }
  const std::size_t rest = contents.size() - header_bytes - triangles * triangle_bytes;
  if (rest > 0) soup.notes.push_back(fmt::format("skipped {} bytes after the last triangle", rest));
  return soup;
}

}  // namespace

bool has_binary_stl_size(std::string_view contents) {
  return contents.size() >= header_bytes &&
         (contents.size() - header_bytes) ==
             triangle_bytes * std::size_t{load<std::uint32_t>(contents.data() + 80, ByteOrder::little)};
}

bool is_text_stl(std::string_view contents) {
  // A binary STL has a zero byte in its triangle count (below 2^24 triangles), and all but always in its
  // numbers.
  const std::size_t begin = std::min(contents.find_first_not_of(" \t\r\n"), contents.size());
  return same_word(contents.substr(begin, 5), "solid") &&
         contents.substr(0, 2000).find('\0') == contents.npos;
}

PolygonSoup read_stl(std::string_view contents, const std::string& file) {
  PolygonSoup soup =
      is_text_stl(contents) ? TextStlReader(contents, file).read() : read_binary(contents, file);
  const CoincidentPoints coincident = coincident_points(soup.points);
  const std::size_t corners = soup.points.size();
  join(soup, coincident);
  if (coincident.duplicates > 0)
    soup.notes.push_back(fmt::format("joined {} STL corners to {} vertices", corners, soup.points.size()));
  return soup;
}

}  // namespace nanocarbon::mesh
