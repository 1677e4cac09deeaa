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

constexpr std::string_view blanks = " \t";

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool is_of_a_name(char c) {
  return (lower(c) >= 'a' && lower(c) <= 'z') || (c >= '0' && c <= '9') || c == '_';
}

// Whether a text ends with a name, which is given in lower case, in whichever case.
bool ends_with_name(std::string_view text, std::string_view name) {
  if (text.size() < name.size()) return false;
  const std::size_t begin = text.size() - name.size();
  return (begin == 0 || !is_of_a_name(text[begin - 1])) &&
         std::equal(name.begin(), name.end(), text.begin() + static_cast<std::ptrdiff_t>(begin),
                    [](char n, char c) { return n == lower(c); });
}

// What follows the last "name=" of a text.
std::optional<std::string_view> set_to(std::string_view text, std::string_view name) {
  std::string_view before = text;
  for (std::size_t at = text.rfind('='); at != text.npos; at = before.rfind('=')) {
    before = text.substr(0, at);
    if (!ends_with_name(before.substr(0, before.find_last_not_of(blanks) + 1), name)) continue;
    const std::string_view value = text.substr(at + 1);
    return value.substr(std::min(value.find_first_not_of(blanks), value.size()));
  }
  return std::nullopt;
}

// What stands between the quotes there; without any, nothing.
std::optional<std::string_view> value_of(std::string_view line, std::string_view name) {
  const auto value = set_to(line, name);
  if (!value) return std::nullopt;
  if (!value->starts_with('"') && !value->starts_with('\'')) return "";
  const std::size_t end = value->find(value->front(), 1);
  return end == value->npos ? "" : value->substr(1, end - 1);
}

// "lattice=hexagonal" is no cell, nor is "lattice = 20.5 Angstrom" one, but what is quoted, in brackets or begins with two
// numbers is meant as one.
bool is_meant_as_cell(std::string_view value) {
  if (value.empty()) return false;
  if (std::string_view("\"'[{(").find(value.front()) != value.npos) return true;
  double number = 0;
  for (int k = 0; k < 2; ++k) {
    value.remove_prefix(std::min(value.find_first_not_of(" \t,"), value.size()));
    const std::string_view word = value.substr(0, value.find_first_of(" \t,\r\n"));
    if (word.empty() || read_real(word, number) != NumberToken::number) return false;
    value.remove_prefix(word.size());
  }
  return true;
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
  return fmt::format("Lattice=\"{} {} {} {} {} {} {} {} {}\" Origin=\"{} {} {}\" pbc=\"{} {} {}\"", m(0, 0),
                     m(1, 0), m(2, 0), m(0, 1), m(1, 1), m(2, 1), m(0, 2), m(1, 2), m(2, 2), o[0], o[1], o[2],
                     flag(0), flag(1), flag(2));
}

std::optional<Cell> cell_in_comment(std::string_view contents, const std::string& file) {
  if (contents.starts_with("ply")) contents = contents.substr(0, contents.find("end_header"));
  const auto value = set_to(contents, "lattice");
  if (!value || !is_meant_as_cell(*value)) return std::nullopt;
  const auto line = comment_line(contents, static_cast<std::size_t>(value->data() - contents.data()));
  if (!line) return std::nullopt;
  const auto fail = [&](const char* what) {
    throw UserError(
        Failure::malformed,
        fmt::format("{}: the comment with a cell, \"{}\", {}; give Lattice=\"nine numbers\", the cell's "
                    "edges one after the other",
                    file, *line, what));
  };
  const std::vector<double> edges = numbers_in(value_of(*line, "lattice").value_or(""));
  if (edges.size() != 9) fail("does not have nine numbers");
  Cell cell;
  for (int k = 0; k < 9; ++k) cell.vectors(k % 3, k / 3) = edges[static_cast<std::size_t>(k)];
  if (const auto origin = value_of(*line, "origin")) {
    const std::vector<double> corner = numbers_in(*origin);
    if (corner.size() != 3) fail("does not have three numbers in Origin");
    cell.origin = Vec3(corner[0], corner[1], corner[2]);
  }
  if (const auto flags = value_of(*line, "pbc")) {
    std::size_t d = 0;
    for (const char c : *flags)
      if ((lower(c) == 't' || lower(c) == 'f') && d < 3) cell.periodic[d++] = lower(c) == 't';
    if (d != 3) fail("does not have three letters T or F in pbc");
  }
  return cell;
}

}  // namespace nanocarbon::mesh
