// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/cell_comment.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "nanocarbon/core/error.h"
#include "nanocarbon/core/text_numbers.h"

namespace nanocarbon::mesh {
namespace {

constexpr std::string_view key = "Lattice=\"";

// What stands between the quotes after a name and an equals sign.
std::optional<std::string_view> value_of(std::string_view line, std::string_view name) {
  const std::size_t at = line.find(name);
  if (at == line.npos) return std::nullopt;
  line.remove_prefix(at + name.size());
  const std::size_t end = line.find('"');
  if (end == line.npos) return std::nullopt;
  return line.substr(0, end);
}

// Nothing where one of them is not a number.
std::vector<double> numbers_in(std::string_view text) {
  constexpr const char* between = " \t,";
  std::vector<double> numbers;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(between), text.size()));
    if (text.empty()) return numbers;
    const std::string_view word = text.substr(0, text.find_first_of(between));
    if (read_real(word, numbers.emplace_back()) != NumberToken::number) return {};
    text.remove_prefix(word.size());
  }
}

// The comment line around a place; nothing where it is not in a comment.
std::optional<std::string_view> comment_line(std::string_view contents, std::size_t at) {
  std::size_t begin = contents.find_last_of("\r\n", at);
  begin = begin == contents.npos ? 0 : begin + 1;
  const std::size_t end = contents.find_first_of("\r\n", at);
  const std::string_view line = contents.substr(begin, end == contents.npos ? end : end - begin);
  if (line.starts_with("#") || line.starts_with("comment")) return line;
  return std::nullopt;
}

}  // namespace

std::string cell_comment(const Cell& cell) {
  const Mat3& m = cell.vectors;
  const Vec3& o = cell.origin;
  const auto flag = [&](std::size_t d) { return cell.periodic[d] ? 'T' : 'F'; };
  return fmt::format("{}{} {} {} {} {} {} {} {} {}\" Origin=\"{} {} {}\" pbc=\"{} {} {}\"", key, m(0, 0),
                     m(1, 0), m(2, 0), m(0, 1), m(1, 1), m(2, 1), m(0, 2), m(1, 2), m(2, 2), o[0], o[1], o[2],
                     flag(0), flag(1), flag(2));
}

std::optional<Cell> cell_in_comment(std::string_view contents, const std::string& file) {
  if (contents.starts_with("ply")) contents = contents.substr(0, contents.find("end_header"));
  const std::size_t at = contents.rfind(key);
  if (at == contents.npos) return std::nullopt;
  const auto line = comment_line(contents, at);
  if (!line) return std::nullopt;
  const auto fail = [&](const char* what) {
    throw UserError(
        Failure::malformed,
        fmt::format("{}: the comment with a cell, \"{}\", {}; give Lattice=\"nine numbers\", the cell's "
                    "edges one after the other",
                    file, *line, what));
  };
  const std::vector<double> edges = numbers_in(value_of(*line, key).value_or(""));
  if (edges.size() != 9) fail("does not have nine numbers");
  Cell cell;
  for (int k = 0; k < 9; ++k) cell.vectors(k % 3, k / 3) = edges[static_cast<std::size_t>(k)];
  if (const auto origin = value_of(*line, "Origin=\"")) {
    const std::vector<double> corner = numbers_in(*origin);
    if (corner.size() != 3) fail("does not have three numbers in Origin");
    cell.origin = Vec3(corner[0], corner[1], corner[2]);
  }
  if (const auto flags = value_of(*line, "pbc=\"")) {
    std::size_t d = 0;
    for (const char c : *flags)
      if ((c == 'T' || c == 'F') && d < 3) cell.periodic[d++] = c == 'T';
    if (d != 3) fail("does not have three letters T or F in pbc");
  }
  return cell;
}

}  // namespace nanocarbon::mesh
