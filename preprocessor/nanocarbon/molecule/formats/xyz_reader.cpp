// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/formats/text_input.h"
#include "nanocarbon/molecule/formats/xyz.h"

namespace nanocarbon::molecule {
namespace {

using Keys = std::map<std::string, std::string_view>;  // keys in lower case

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

// key=value pairs, where values may be quoted or bracketed; words without "=" are passed over.
Keys parse_comment(std::string_view text) {
  Keys keys;
  std::size_t i = 0;
  while (i < text.size()) {
    const std::size_t begin = text.find_first_not_of(" \t\r", i);
    if (begin == std::string_view::npos) break;
    i = std::min(text.find_first_of("= \t\r", begin), text.size());
    const std::string key = lower(text.substr(begin, i - begin));
    if (i == text.size() || text[i] != '=') continue;
    ++i;
    const std::string_view openings = "\"'{[", closings = "\"'}]";
    const std::size_t kind = i < text.size() ? openings.find(text[i]) : std::string_view::npos;
    const bool enclosed = kind != std::string_view::npos;
    if (enclosed) ++i;
    const std::size_t end =
        std::min(enclosed ? text.find(closings[kind], i) : text.find_first_of(" \t\r", i), text.size());
    keys[key] = text.substr(i, end - i);
    i = end < text.size() ? end + 1 : end;
  }
  return keys;
}

struct Columns {
  std::size_t species = 0, position = 1, least = 4;
};

Columns parse_properties(const TextInput& input, std::string_view text) {
  Columns columns{0, 0, 0};
  bool species = false, position = false;
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
    const std::string name = lower(parts[0]);
    if ((name == "species" || name == "z" || name == "numbers") && count == 1 && !species) {
      columns.species = column;
      species = true;
    }
    if ((name == "pos" || name == "positions") && count == 3) {
      columns.position = column;
      position = true;
    }
    column += static_cast<std::size_t>(count);
  }
  if (!species || !position) input.fail("Properties must have species (S:1) and pos (R:3)");
  columns.least = std::max(columns.species + 1, columns.position + 3);
  return columns;
}

std::vector<double> numbers(const TextInput& input, std::string_view text, std::size_t count,
                            std::string_view what) {
  std::string separated(text);
  std::replace(separated.begin(), separated.end(), ',', ' ');
  std::vector<std::string_view> words;
  split_words(separated, words);
  if (words.size() != count)
    input.fail(fmt::format("{} must have {} numbers, found {}", what, count, words.size()));
  std::vector<double> values;
  for (const std::string_view word : words) values.push_back(input.coordinate(word, what));
  return values;
}

std::array<bool, 3> parse_pbc(const TextInput& input, std::string_view text) {
  std::string separated(text);
  std::replace(separated.begin(), separated.end(), ',', ' ');
  std::vector<std::string_view> words;
  split_words(separated, words);
  if (words.size() != 3) input.fail("pbc must have three values");
  std::array<bool, 3> periodic;
  for (int d = 0; d < 3; ++d) {
    const std::string word = lower(words[d]);
    periodic[d] = word == "t" || word == "true" || word == "1";
    if (!periodic[d] && word != "f" && word != "false" && word != "0")
      input.fail("pbc must be T or F each way");
  }
  return periodic;
}

// Open directions may be given without a vector, as ASE's sheets and tubes have them.
void complete_open_directions(Cell& cell) {
  for (int d = 0; d < 3; ++d) {
    if (cell.periodic[d] || !cell.vectors.col(d).isZero(0.0)) continue;
    Vec3 others[2] = {cell.vectors.col((d + 1) % 3), cell.vectors.col((d + 2) % 3)};
    for (int k = 0; k < 2; ++k)
      if (others[k].isZero(0.0))
        others[k] = others[1 - k].isZero(0.0) ? Vec3::Unit(d) : others[1 - k].unitOrthogonal();
    cell.vectors.col(d) = others[0].cross(others[1]).normalized();
  }
}

std::optional<Cell> parse_cell(const TextInput& input, const Keys& keys) {
  const auto lattice = keys.find("lattice");
  if (lattice == keys.end()) return std::nullopt;
  Cell cell;
  const std::vector<double> v = numbers(input, lattice->second, 9, "Lattice");
  for (int d = 0; d < 3; ++d) cell.vectors.col(d) = Vec3(v[3 * d], v[3 * d + 1], v[3 * d + 2]);
  if (const auto origin = keys.find("origin"); origin != keys.end()) {
    const std::vector<double> o = numbers(input, origin->second, 3, "Origin");
    cell.origin = Vec3(o[0], o[1], o[2]);
  }
  if (const auto pbc = keys.find("pbc"); pbc != keys.end()) cell.periodic = parse_pbc(input, pbc->second);
  if (cell.periodic == std::array<bool, 3>{false, false, false}) return std::nullopt;
  complete_open_directions(cell);
  const double size = cell.vectors.colwise().norm().prod(), inside = cell.vectors.determinant();
  if (!(std::abs(inside) > 1e-9 * size)) input.fail("the Lattice vectors do not span a volume");
  if (inside < 0.0) input.fail("the Lattice vectors are left-handed; exchange two of them");
  return cell;
}

Element parse_element(const TextInput& input, std::string_view text) {
  if (const auto element = element_from_symbol(text)) return *element;
  if (text == "6") return Element::carbon;
  if (text == "1") return Element::hydrogen;
  input.fail(fmt::format("expected C or H, found '{}'", text.substr(0, 20)));
}

bool next_line_with_text(TextInput& input) {
  while (input.next_line())
    if (!trimmed(input.line()).empty()) return true;
  return false;
}

Molecule read_frame(TextInput& input) {
  std::vector<std::string_view> words;
  split_words(input.line(), words);
  if (words.size() != 1) input.fail("expected the number of atoms alone on its line");
  const std::int64_t atoms = input.integer(words[0], "the number of atoms");
  if (atoms < 0 || atoms >= 0xffffffff) input.fail(fmt::format("there cannot be {} atoms", atoms));
  if (!input.next_line()) input.fail("the file ends before the comment line");
  const Keys keys = parse_comment(input.line());
  Molecule molecule;
  molecule.cell = parse_cell(input, keys);
  Columns columns;
  if (const auto p = keys.find("properties"); p != keys.end()) columns = parse_properties(input, p->second);

  const auto possible = std::min<std::size_t>(static_cast<std::size_t>(atoms), input.size() / 6 + 1);
  molecule.positions.reserve(possible);
  molecule.elements.reserve(possible);
  for (std::int64_t i = 0; i < atoms; ++i) {
    if (!input.next_line()) input.fail(fmt::format("the file ends after {} of {} atoms", i, atoms));
    split_words(input.line(), words);
    if (words.size() < columns.least)
      input.fail(fmt::format("expected at least {} columns for atom {}, found {}", columns.least, i + 1,
                             words.size()));
    molecule.elements.push_back(parse_element(input, words[columns.species]));
    const std::size_t x = columns.position;
    molecule.positions.emplace_back(input.coordinate(words[x], "x"), input.coordinate(words[x + 1], "y"),
                                    input.coordinate(words[x + 2], "z"));
  }
  return molecule;
}

std::vector<Molecule> read_frames(TextInput& input, std::size_t most) {
  std::vector<Molecule> frames;
  while (frames.size() < most && next_line_with_text(input)) frames.push_back(read_frame(input));
  if (frames.empty()) input.fail("the file is empty; expected the number of atoms");
  return frames;
}

}  // namespace

std::vector<Molecule> read_xyz_frames(const std::filesystem::path& path) {
  TextInput input(path);
  return read_frames(input, static_cast<std::size_t>(-1));
}

std::vector<Molecule> read_xyz_frames(std::istream& in, const std::string& name) {
  TextInput input(in, name);
  return read_frames(input, static_cast<std::size_t>(-1));
}

Molecule read_xyz(const std::filesystem::path& path) {
  TextInput input(path);
  return read_frames(input, 1).front();
}

}  // namespace nanocarbon::molecule
