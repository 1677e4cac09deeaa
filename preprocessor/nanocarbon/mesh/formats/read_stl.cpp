// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/read_stl.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/join_points.h"
#include "nanocarbon/mesh/parsing/byte_order.h"
#include "nanocarbon/mesh/parsing/text_scanner.h"

namespace nanocarbon::mesh {
namespace {

constexpr std::size_t header_bytes = 84;    // free text (80), number of triangles (4)
constexpr std::size_t triangle_bytes = 50;  // normal (12), corners (36), attribute (2)

bool same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

bool is_keyword(std::string_view word) {
  for (const char* keyword : {"solid", "facet", "outer", "vertex", "endloop", "endfacet", "endsolid"})
    if (same_word(word, keyword)) return true;
  return false;
}

bool is_comment(std::string_view word) {
  return word.starts_with('#') || word.starts_with(';') || word.starts_with("//") ||
         same_word(word, "color") || same_word(word, "colour");
}

// Goes by words: most programs have a line for each keyword, some a line for each triangle, or for all of them. What
// a line has beyond that (normals that may be anything, colours) is passed over.
class TextStlReader {
 public:
  TextStlReader(std::string_view text, const std::string& file) : scanner_(text, file, {'\0', false}) {}

  PolygonSoup read() {
    bool open = false, begun = false;
    while (scanner_.next_line()) {
      for (std::string_view word = scanner_.word(); !word.empty(); word = scanner_.word()) {
        if (same_word(word, "facet")) {
          read_facet();
          open = begun = true;
          continue;
        }
        if (same_word(word, "solid")) {
          open = begun = true;
        } else if (same_word(word, "endsolid") || same_word(word, "end")) {  // end solid
          open = false;
        } else if (begun && !is_comment(word)) {
          scanner_.fail(fmt::format("expected 'facet' or 'endsolid', found {}", quoted(word)));
        }
        skip_text();
      }
    }
    if (open) soup_.notes.push_back("the last line, 'endsolid', is missing");
    return std::move(soup_);
  }

 private:
  // The rest of the line, or what of it comes before a triangle.
  void skip_text() {
    for (TextScanner before = scanner_; !scanner_.at_line_end(); before = scanner_) {
      if (!same_word(scanner_.word(), "facet")) continue;
      TextScanner after = scanner_;
      if (!same_word(after.word(), "normal")) continue;
      scanner_ = std::move(before);
      return;
    }
  }

  void read_facet() {
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
    bool begins_line = false;
    for (;;) {
      std::string_view word = scanner_.word();
      if (word.empty()) {
        if (!scanner_.next_line())
          scanner_.fail(fmt::format("the file ends within triangle {}", soup_.faces()));
        begins_line = true;
        continue;
      }
      if (same_word(word, keyword)) return;
      if (same_word(word, "end") && keyword.starts_with("end")) {  // end loop, end facet
        const std::string_view second = scanner_.word();
        if (same_word(second, keyword.substr(3))) return;
        word = second;
      }
      if (begins_line || is_keyword(word))
        scanner_.fail(
            fmt::format("expected '{}' in triangle {}, found {}", keyword, soup_.faces(), quoted(word)));
    }
  }

  TextScanner scanner_;
  PolygonSoup soup_;
};

bool has_size_in(ByteOrder order, std::string_view contents) {
  return contents.size() >= header_bytes &&
         (contents.size() - header_bytes) ==
             triangle_bytes * std::size_t{load<std::uint32_t>(contents.data() + 80, order)};
}

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
  // A few programs wrote the other byte order; only where the count, read so, is right.
  const ByteOrder order = has_size_in(ByteOrder::big, contents) && !has_size_in(ByteOrder::little, contents)
                              ? ByteOrder::big
                              : ByteOrder::little;
  const std::size_t promised = load<std::uint32_t>(contents.data() + 80, order);
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
        point[static_cast<int>(d)] = load<float>(contents.data() + byte, order);
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
  if (order == ByteOrder::big) soup.notes.push_back("the file is in big-endian byte order, which STL is not");
  const std::size_t rest = contents.size() - header_bytes - triangles * triangle_bytes;
  if (rest > 0) soup.notes.push_back(fmt::format("skipped {} bytes after the last triangle", rest));
  return soup;
}

bool is_plain_text(std::string_view head) {
  return std::all_of(head.begin(), head.end(), [](char c) {
    return (static_cast<unsigned char>(c) >= 32 && c != '\x7f') || c == '\n' || c == '\r' || c == '\t' ||
           c == '\f';
  });
}

}  // namespace

bool has_binary_stl_size(std::string_view contents) {
  return has_size_in(ByteOrder::little, contents) || has_size_in(ByteOrder::big, contents);
}

bool is_text_stl(std::string_view contents) {
  // A binary STL has a zero byte in its triangle count (below 2^24 triangles), and all but always in its
  // numbers.
  const std::string_view head = contents.substr(0, 2000);
  if (head.find('\0') != head.npos) return false;
  const std::size_t begin = std::min(contents.find_first_not_of(" \t\r\n"), contents.size());
  if (same_word(contents.substr(begin, 5), "solid")) return true;
  // What some programs put before the first solid, or instead of it.
  std::string lower(head);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::size_t facet = lower.find("facet"), outer = lower.find("outer", facet);
  return facet != lower.npos && outer != lower.npos && lower.find("vertex", outer) != lower.npos;
}

PolygonSoup read_stl(std::string_view contents, const std::string& file) {
  const bool text = is_text_stl(contents);
  const bool blank = contents.find_first_not_of(" \t\r\n") == contents.npos;
  if (!text && !blank && is_plain_text(contents.substr(0, 2000)) && !has_binary_stl_size(contents))
    fail_at_line(file, 1,
                 fmt::format("the file is text, but no STL, which begins with 'solid': it begins with {}",
                             quoted(contents.substr(0, contents.find_first_of("\r\n")))),
                 "give a mesh file");
  PolygonSoup soup = text ? TextStlReader(contents, file).read() : read_binary(contents, file);
  const CoincidentPoints coincident = coincident_points(soup.points);
  const std::size_t corners = soup.points.size();
  join(soup, coincident);
  if (coincident.duplicates > 0)
    soup.notes.push_back(fmt::format("joined {} STL corners to {} vertices", corners, soup.points.size()));
  return soup;
}

}  // namespace nanocarbon::mesh
