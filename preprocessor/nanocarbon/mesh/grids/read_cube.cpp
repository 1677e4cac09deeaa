// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/grids/read_cube.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>

#include "nanocarbon/core/error.h"
#include "nanocarbon/core/text_numbers.h"
#include "nanocarbon/mesh/parsing/value_cursor.h"

namespace nanocarbon::mesh {
namespace {

// Which of the values that are given at each place is taken.
std::size_t chosen(const std::vector<std::string>& names, const std::string& array, const std::string& file) {
  if (names.size() == 1) return 0;
  const auto found = std::find(names.begin(), names.end(), array);
  if (found == names.end())
    throw UserError(
        Failure::usage,
        fmt::format(
            "{}: the cube file has {} fields, of which one has to be named with --field: {}", file,
            names.size(),
            fmt::join(names.begin(),
                      names.begin() + std::min<std::ptrdiff_t>(20, static_cast<std::ptrdiff_t>(names.size())),
                      ", ")));
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace

ScalarField read_cube(std::string_view text, const std::string& file, const std::string& array) {
  ValueCursor cursor(text, file);
  cursor.line();
  cursor.line();
  ScalarField field;
  const std::int64_t atoms = cursor.integer("number of atoms");
  for (int d = 0; d < 3; ++d) field.origin[d] = cursor.coordinate("origin");
  const std::string_view rest = cursor.line();  // perhaps how many values there are at each place
  std::int64_t per_place = 1;
  if (rest.find_first_not_of(" \t") != rest.npos) {
    ValueCursor number(rest, file);
    per_place = number.integer("number of values at each place");
    if (per_place < 1 || per_place > 1000)
      cursor.fail(fmt::format("there are {} values at each place", per_place));
  }
  int angstroms = 0;
  for (int edge = 0; edge < 3; ++edge) {
    const std::int64_t count = cursor.integer("number of values along an edge");
    if (std::abs(count) > 1'000'000'000) cursor.fail(fmt::format("{} values along an edge", count));
    angstroms += count < 0;
    field.counts[static_cast<std::size_t>(edge)] = static_cast<std::size_t>(std::abs(count));
    for (int d = 0; d < 3; ++d) field.steps(d, edge) = cursor.coordinate("step along an edge");
  }
  if (angstroms != 0 && angstroms != 3)
    cursor.fail("some numbers of values are negative (Angstrom), but not all");
  field.unit = angstroms ? "Angstrom" : "Bohr";
  for (std::int64_t atom = 0; atom < std::abs(atoms); ++atom) {
    cursor.integer("atomic number");
    for (int i = 0; i < 4; ++i) cursor.real("number of an atom");
  }
  std::vector<std::string> names;
  if (atoms < 0) {  // orbitals: how many, and their numbers
    per_place = cursor.integer("number of orbitals");
    if (per_place < 1 || per_place > 100'000) cursor.fail(fmt::format("there are {} orbitals", per_place));
    for (std::int64_t i = 0; i < per_place; ++i) names.emplace_back(cursor.word());
  } else {
    for (std::int64_t i = 1; i <= per_place; ++i) names.push_back(std::to_string(i));
  }
  const std::size_t take = chosen(names, array, file), size = require_grid(field, file);
  const auto each = static_cast<std::size_t>(per_place);
  if (cursor.remaining() / 2 < size * each)
    cursor.fail(fmt::format("the file ends before its {} values", size * each));
  std::vector<float> values;
  values.reserve(size);
  for (std::size_t i = 0; i < size * each; ++i) {
    const double value = cursor.real("value of the field");
    if (i % each == take) values.push_back(static_cast<float>(value));
  }
  field.values = last_index_fastest(values, field.counts);
  require_finite(field, file);
  if (!cursor.at_end()) field.notes.push_back("skipped what follows the last value of the field");
  return field;
}

bool begins_like_cube(std::string_view text) {
  text = text.substr(0, 4000);
  ValueCursor lines(text, "");
  lines.line();
  lines.line();
  for (int line = 0; line < 4; ++line) {
    ValueCursor words(lines.line(), "");
    std::int64_t count = 0;
    double number = 0.0;
    if (read_integer(words.word(), count) != NumberToken::number) return false;
    for (int d = 0; d < 3; ++d)
      if (read_real(words.word(), number) != NumberToken::number) return false;
    if (line > 0 && (count == 0 || !words.at_end())) return false;
  }
  return true;
}

}  // namespace nanocarbon::mesh
