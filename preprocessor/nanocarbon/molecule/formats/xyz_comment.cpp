// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/xyz_comment.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "nanocarbon/core/error.h"

namespace nanocarbon::molecule {
namespace {

using Keys = std::map<std::string, std::string_view>;  // keys in lower case

// The end of a value that begins with a bracket, which may hold others.
std::size_t closing_bracket(std::string_view text, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    depth += text[i] == '[' || text[i] == '{';
    depth -= text[i] == ']' || text[i] == '}';
    if (depth == 0) return i;
  }
  return text.size();
}

// key=value pairs, where values may be quoted or bracketed; words without "=" are passed over.
Keys parse_keys(std::string_view text) {
  Keys keys;
  std::size_t i = 0;
  while (i < text.size()) {
    const std::size_t begin = text.find_first_not_of(" \t\r", i);
    if (begin == std::string_view::npos) break;
    i = std::min(text.find_first_of("= \t\r", begin), text.size());
    const std::string key = lower_case(text.substr(begin, i - begin));
    if (i == text.size() || text[i] != '=') continue;
    ++i;
    const char opening = i < text.size() ? text[i] : ' ';
    std::size_t end = 0;
    if (opening == '"' || opening == '\'')
      end = text.find(opening, ++i);
    else if (opening == '[' || opening == '{')
      end = closing_bracket(text, i++);
    else
      end = text.find_first_of(" \t\r", i);
    end = std::min(end, text.size());
    keys[key] = text.substr(i, end - i);
    i = end < text.size() ? end + 1 : end;
  }
  return keys;
}

// Values may stand in brackets and between commas: "[[1, 0, 0], [0, 1, 0], [0, 0, 1]]".
void split_values(std::string_view text, std::string& separated, std::vector<std::string_view>& words) {
  separated = text;
  for (char& c : separated)
    if (c == ',' || c == '[' || c == ']' || c == '{' || c == '}') c = ' ';
  split_words(separated, words);
}

Vec3 vector_of(const TextInput& input, const std::vector<std::string_view>& words, std::size_t first,
               std::string_view what) {
  return {input.coordinate(words[first], what), input.coordinate(words[first + 1], what),
          input.coordinate(words[first + 2], what)};
}

std::vector<std::string_view> values(const TextInput& input, std::string_view text, std::size_t count,
                                     std::string_view what, std::string& separated) {
  std::vector<std::string_view> words;
  split_values(text, separated, words);
  if (words.size() != count)
    input.fail(fmt::format("{} must have {} values, found {}", what, count, words.size()));
  return words;
}

std::array<bool, 3> parse_pbc(const TextInput& input, std::string_view text) {
  std::string separated;
  const auto words = values(input, text, 3, "pbc", separated);
  std::array<bool, 3> periodic;
  for (std::size_t d = 0; d < 3; ++d) {
    const std::string word = lower_case(words[d]);
    periodic[d] = word == "t" || word == "true" || word == "1";
    if (!periodic[d] && word != "f" && word != "false" && word != "0")
      input.fail(fmt::format("pbc must be T or F each way, found '{}'", shown(words[d])));
  }
  return periodic;
}

std::optional<Cell> parse_cell(const TextInput& input, const Keys& keys, const ReadSettings& settings,
                               std::optional<Cell>& whole) {
  for (const char* mark : {"CELL(", "CELL{", "cell{", "positions{"})  // of i-PI, often in Bohr
    if (input.line().find(mark) != std::string_view::npos)
      throw UserError(
          Failure::unsuitable,
          fmt::format("{}:{}: the comment gives cell and units in i-PI's form, which is not read; "
                      "give the cell as Lattice=\"ax ay az bx by bz cx cy cz\", all in Angstrom",
                      input.name(), input.number()));
  const auto lattice = keys.find("lattice"), pbc = keys.find("pbc");
  Cell cell;
  if (pbc != keys.end()) cell.periodic = parse_pbc(input, pbc->second);
  if (lattice == keys.end() && settings.cell) {
    // Programs that know no cell write pbc="F F F".
    const bool says = pbc != keys.end() && cell.periodic != std::array{false, false, false};
    cell = {settings.cell->vectors, settings.cell->origin, says ? cell.periodic : settings.cell->periodic};
    return cell_as_read(input, cell, settings);
  }
  if (lattice == keys.end()) {
    require_free_space(input, settings);
    if (pbc != keys.end() && !settings.periodic && cell.periodic != std::array{false, false, false})
      throw UserError(
          Failure::unsuitable,
          fmt::format(
              "{}:{}: pbc says that the structure is periodic, but there is no Lattice: add "
              "Lattice=\"ax ay az bx by bz cx cy cz\" to this line or give --cell, or read the structure in "
              "free space with --boundary 'f f f'",
              input.name(), input.number()));
    return std::nullopt;
  }
  if (settings.cell)
    throw UserError(Failure::usage, fmt::format("{}:{}: the file gives its cell as Lattice; leave out --cell",
                                                input.name(), input.number()));
  std::string separated;
  const auto words = values(input, lattice->second, 9, "Lattice", separated);
  for (int d = 0; d < 3; ++d)
    cell.vectors.col(d) = vector_of(input, words, 3 * static_cast<std::size_t>(d), "Lattice");
  if (const auto origin = keys.find("origin"); origin != keys.end())
    cell.origin = vector_of(input, values(input, origin->second, 3, "Origin", separated), 0, "Origin");
  const bool open = std::count(cell.periodic.begin(), cell.periodic.end(), false) > 0;
  if (open && !settings.periodic && cell.vectors.determinant() > 1.0) whole = cell;
  return cell_as_read(input, cell, settings);
}

// "name:kind:count:name:kind:count", where kind is S, R, I or L.
XyzColumns parse_properties(const TextInput& input, std::string_view text) {
  XyzColumns columns;
  std::optional<std::size_t> species, numbers, position;
  std::size_t column = 0;
  while (!text.empty()) {
    std::string_view parts[3];
    for (std::string_view& part : parts) {
      const std::size_t end = std::min(text.find(':'), text.size());
      part = text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    const std::int64_t count = input.integer(parts[2], "the number of columns of a property");
    if (count < 1 || count > 1000) input.fail(fmt::format("a property cannot have {} columns", count));
    const std::string name = lower_case(parts[0]);
    if (count == 1 && !species &&
        (name == "species" || name == "symbol" || name == "symbols" || name == "element" ||
         name == "elements"))
      species = column;
    if (count == 1 && (name == "z" || name == "numbers" || name == "atomic_numbers")) numbers = column;
    if (count == 1 && name == "id") columns.id = column;
    if (count == 3 && (name == "pos" || name == "positions" || name == "position")) position = column;
    column += static_cast<std::size_t>(count);
  }
  if (!position || (!species && !numbers))
    input.fail("Properties must have species (S:1) or Z (I:1), and pos (R:3)");
  columns.atomic_numbers = !species;
  columns.species = species ? *species : *numbers;
  columns.position = *position;
  columns.least = std::max({columns.species + 1, columns.position + 3, columns.id ? *columns.id + 1 : 0});
  return columns;
}

// "Atoms. Timestep: 1000", as LAMMPS's dump xyz writes it.
std::optional<std::int64_t> step_of_lammps(std::string_view line) {
  constexpr std::string_view before = "Timestep:";
  const std::size_t at = line.find(before);
  std::vector<std::string_view> words;
  if (at != std::string_view::npos) split_words(line.substr(at + before.size()), words);
  std::int64_t step = 0;
  if (words.empty() || !parse_integer(words[0], step)) return std::nullopt;
  return step;
}

}  // namespace

XyzComment parse_xyz_comment(const TextInput& input, const ReadSettings& settings) {
  const Keys keys = parse_keys(input.line());
  XyzComment comment;
  comment.cell = parse_cell(input, keys, settings, comment.lattice);
  if (const auto p = keys.find("properties"); p != keys.end())
    comment.columns = parse_properties(input, p->second);
  comment.step = step_of_lammps(input.line());
  for (const char* key : {"step", "timestep"}) {
    std::int64_t step = 0;
    if (const auto found = keys.find(key); found != keys.end() && parse_integer(found->second, step))
      comment.step = step;
  }
  return comment;
}

}  // namespace nanocarbon::molecule
