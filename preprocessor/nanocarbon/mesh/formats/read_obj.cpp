// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/read_obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include "nanocarbon/mesh/parsing/text_scanner.h"

namespace nanocarbon::mesh {
namespace {

// Statements of the format that say nothing about polygons. Anything else is passed over too, but told.
constexpr std::array passed_over = {"vt",     "vn", "g", "o", "s",      "usemtl",
                                    "mtllib", "mg", "l", "p", "usemap", "maplib"};

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& file) : scanner_(text, file, {'#', true}) {}

  PolygonSoup read() {
    while (scanner_.next_line()) {
      const std::string_view keyword = scanner_.word();
      if (keyword == "v")
        read_vertex();
      else if (keyword == "f" || keyword == "fo")  // fo: the name before version 3 of the format
        read_face();
      else if (std::find(passed_over.begin(), passed_over.end(), keyword) == passed_over.end())
        ++unknown_[quoted(keyword)];
    }
    if (soup_.points.empty()) scanner_.fail("the file has no vertices (lines 'v x y z')", "give a mesh file");
    check_largest();
    tell_unknown();
    return std::move(soup_);
  }

 private:
  void read_vertex() {
    const double x = scanner_.coordinate("x coordinate");
    const double y = scanner_.coordinate("y coordinate");
    const double z = scanner_.coordinate("z coordinate");
    soup_.points.emplace_back(x, y, z);
  }

  void read_face() {
    std::size_t corners = 0;
    for (std::string_view word = scanner_.word(); !word.empty(); word = scanner_.word(), ++corners)
      soup_.corners.push_back(vertex_of(word));
    if (corners < 3)
      scanner_.fail(fmt::format("face {} has {} corners", soup_.faces(), corners), "remove this face");
    soup_.close_face();
  }

  // The vertex of a corner such as "7", "7/3", "7//2", "7/3/2" or "-1"; texture coordinate and normal may be
  // empty ("7/", "7//", "7/3/"), as some programs write them where they have none.
  VertexIndex vertex_of(std::string_view corner) {
    std::array<std::int64_t, 3> numbers = {0, 0, 0};
    const char* at = corner.data();
    const char* const end = at + corner.size();
    for (std::size_t part = 0;; ++part) {
      const bool is_empty = part > 0 && (at == end || *at == '/');
      if (!is_empty) {
        const auto [after, error] = std::from_chars(at, end, numbers[part]);
        if (error != std::errc()) not_a_corner(corner);
        at = after;
      }
      if (at == end) break;
      if (*at != '/' || part == 2) not_a_corner(corner);
      ++at;
    }
    return vertex_of(numbers[0]);
  }

  VertexIndex vertex_of(std::int64_t number) {
    const auto known = static_cast<std::int64_t>(soup_.points.size());
    if (number == 0) scanner_.fail("a face uses vertex 0, but OBJ files number from 1");
    if (number < 0) {
      if (number < -known)
        scanner_.fail(fmt::format("a face uses vertex {}, but only {} come before it", number, known));
      return static_cast<VertexIndex>(known + number);
    }
    // A face may come before its vertices, so this number is checked at the end.
    if (number > largest_) {
      largest_ = number;
      line_of_largest_ = scanner_.line_number();
      if (number > std::numeric_limits<VertexIndex>::max()) check_largest();
    }
    return static_cast<VertexIndex>(number - 1);
  }

  [[noreturn]] void not_a_corner(std::string_view corner) {
    scanner_.fail(fmt::format("{} is not a face's corner (v, v/vt, v//vn or v/vt/vn)", quoted(corner)));
  }

  void check_largest() const {
    if (largest_ > static_cast<std::int64_t>(soup_.points.size()))
      fail_at_line(
          scanner_.file(), line_of_largest_,
          fmt::format("a face uses vertex {}, but there are {} vertices", largest_, soup_.points.size()));
  }

  void tell_unknown() {
    std::size_t shown = 0;
    for (const auto& [keyword, lines] : unknown_) {
      if (++shown > 5) {
        soup_.notes.push_back(fmt::format("skipped lines of {} more kinds", unknown_.size() - 5));
        return;
      }
      soup_.notes.push_back(fmt::format("skipped {} line(s) of the kind {}", lines, keyword));
    }
  }

  TextScanner scanner_;
  PolygonSoup soup_;
  std::int64_t largest_ = 0;
  std::size_t line_of_largest_ = 0;
  std::map<std::string, std::size_t> unknown_;
};

}  // namespace

PolygonSoup read_obj(std::string_view text, const std::string& file) { return ObjReader(text, file).read(); }

}  // namespace nanocarbon::mesh
