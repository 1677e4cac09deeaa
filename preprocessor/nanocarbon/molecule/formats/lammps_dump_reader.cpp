// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/lammps_dump_reader.h"

#include <fmt/format.h>

#include <string>

#include "nanocarbon/molecule/formats/lammps_dump_atoms.h"

namespace nanocarbon::molecule {
namespace {

using Words = std::vector<std::string_view>;

void need_line(TextInput& input, std::string_view what) {
  if (!input.next_line())
    input.fail_at(input.number(), fmt::format("the file ends before {}; the last frame is not whole", what));
}

std::string_view item(std::string_view line) {
  constexpr std::string_view mark = "ITEM:";
  line = trimmed(line);
  return line.starts_with(mark) ? trimmed(line.substr(mark.size())) : std::string_view();
}

// ITEM: BOX BOUNDS [xy xz yz | abc origin] [pp pp ff], and its three lines.
DumpBox read_box(TextInput& input, std::string_view header) {
  Words words;
  split_words(header, words);  // BOX BOUNDS ...
  DumpBox box;
  const bool tilted = words.size() >= 5 && words[2] == "xy", general = words.size() >= 4 && words[2] == "abc";
  const std::size_t first = tilted ? 5 : general ? 4 : 2;
  if (words.size() > first) take_boundary(input, std::span(words).subspan(first), box);
  double rows[3][4] = {};
  const std::size_t columns = general ? 4 : tilted ? 3 : 2;
  for (auto& row : rows) {
    need_line(input, "the end of the box");
    split_words(input.line(), words);
    if (words.size() != columns) input.fail(fmt::format("expected the {} numbers of a box bound", columns));
    for (std::size_t k = 0; k < columns; ++k) row[k] = input.coordinate(words[k], "a box bound");
  }
  if (general) {
    for (int d = 0; d < 3; ++d) {
      box.cell.vectors.col(d) = Vec3(rows[d][0], rows[d][1], rows[d][2]);
      box.cell.origin[d] = rows[d][3];
    }
    return box;
  }
  const double bounds[3][2] = {{rows[0][0], rows[0][1]}, {rows[1][0], rows[1][1]}, {rows[2][0], rows[2][1]}};
  take_bounds(input, bounds, Vec3(rows[0][2], rows[1][2], rows[2][2]), box);
  return box;
}

// The numbers of the frame's ITEMs that come before its atoms.
struct Header {
  std::optional<std::int64_t> step;
  std::optional<std::size_t> atoms;
  std::optional<DumpBox> box;
};

// Reads up to and with the line ITEM: ATOMS, which it leaves as the current one.
Header read_header(TextInput& input) {
  Header header;
  for (;;) {
    const std::string_view name = item(input.line());
    if (name.starts_with("ATOMS")) return header;
    if (name.starts_with("BOX BOUNDS")) {
      header.box = read_box(input, std::string(name));
    } else if (name == "TIMESTEP" || name == "NUMBER OF ATOMS") {
      const bool step = name == "TIMESTEP";
      if (step && header.step) input.fail("the previous frame has no ITEM: ATOMS");
      need_line(input, "the number that belongs here");
      if (step)
        header.step = input.integer(trimmed(input.line()), "the time step");
      else
        header.atoms = input.count(trimmed(input.line()), "atoms");
    } else if (name == "UNITS" || name == "TIME") {
      need_line(input, "what belongs here");
      const std::string_view units = trimmed(input.line());
      if (name == "UNITS" && units != "metal" && units != "real")
        input.fail("the dump has units " + shown(units) +
                   "; its lengths must be in Angstrom (metal or real)");
    } else {
      input.fail("expected a line ITEM: ... of a LAMMPS dump");
    }
    need_line(input, "ITEM: ATOMS");
  }
}

std::string_view unquoted(std::string_view word) {
  if (word.size() >= 2 && (word.front() == '\'' || word.front() == '"') && word.back() == word.front())
    return word.substr(1, word.size() - 2);
  return word;
}

// The members of a list in brackets. LAMMPS leaves a comma after the last.
void read_list(const TextInput& input, std::string_view text, Words& words) {
  text = trimmed(text);
  if (!text.starts_with('[') || !text.ends_with(']')) input.fail("expected a list in brackets: [ ... ]");
  text = text.substr(1, text.size() - 2);
  words.clear();
  while (!trimmed(text).empty()) {
    const std::size_t comma = text.find(',');
    words.push_back(unquoted(trimmed(text.substr(0, comma))));
    text = comma == std::string_view::npos ? std::string_view() : text.substr(comma + 1);
  }
}

// The same of a line that is a member of a list itself: - [ ... ]
void read_row(const TextInput& input, Words& words) {
  const std::string_view line = trimmed(input.line());
  if (!line.starts_with("- ")) input.fail("expected a line - [ ... ]");
  read_list(input, line.substr(1), words);
}

// box: three lines with the bounds, and one with the tilts where it is tilted.
void read_yaml_box(TextInput& input, DumpBox& box) {
  Words words;
  double bounds[3][2];
  Vec3 tilts = Vec3::Zero();
  for (auto& row : bounds) {
    need_line(input, "the end of the box");
    read_row(input, words);
    if (words.size() != 2) input.fail("expected the 2 numbers of a box bound");
    for (std::size_t k = 0; k < 2; ++k) row[k] = input.coordinate(words[k], "a box bound");
  }
  if (input.next_line()) {
    if (trimmed(input.line()).starts_with("- ")) {
      read_row(input, words);
      if (words.size() != 3) input.fail("expected the tilts of the box: xy, xz and yz");
      for (std::size_t k = 0; k < 3; ++k) tilts[static_cast<int>(k)] = input.coordinate(words[k], "a tilt");
    } else {
      input.give_back_line();
    }
  }
  take_bounds(input, bounds, tilts, box);
}

// What stands before the atoms.
struct YamlHeader {
  std::optional<std::int64_t> step;
  std::optional<std::size_t> atoms;
  DumpBox box;
  bool has_box = false;
  std::vector<std::string> columns;
};

// Reads up to and with the line data:
YamlHeader read_yaml_header(TextInput& input) {
  YamlHeader header;
  Words words;
  for (;; need_line(input, "the atoms")) {
    const std::string_view line = input.line();
    if (trimmed(line) == "---" || line.starts_with(' ')) continue;  // of thermo: two lines
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) input.fail("expected a key and a colon of a YAML dump");
    const std::string_view key = trimmed(line.substr(0, colon)), value = trimmed(line.substr(colon + 1));
    if (key == "data") return header;
    if (key == "timestep") header.step = input.integer(value, "the time step");
    if (key == "natoms") header.atoms = input.count(value, "atoms");
    if (key == "units" && value != "metal" && value != "real")
      input.fail("the dump has units " + shown(value) + "; its lengths must be in Angstrom (metal or real)");
    if (key == "boundary") {
      read_list(input, value, words);  // two letters each way
      if (words.size() != 6) input.fail("expected a boundary each way, such as [ p, p, p, p, f, f, ]");
      const std::string ways[] = {std::string(words[0]) + std::string(words[1]),
                                  std::string(words[2]) + std::string(words[3]),
                                  std::string(words[4]) + std::string(words[5])};
      const std::string_view letters[] = {ways[0], ways[1], ways[2]};
      take_boundary(input, letters, header.box);
    }
    if (key == "box") {
      read_yaml_box(input, header.box);
      header.has_box = true;
    }
    if (key == "keywords") {
      read_list(input, value, words);
      header.columns.assign(words.begin(), words.end());
    }
  }
}

}  // namespace

std::optional<MoleculeFrame> read_lammps_dump_frame(TextInput& input, ReadSettings& settings) {
  if (!input.next_line_with_text()) return std::nullopt;
  const Header header = read_header(input);
  if (!header.atoms) input.fail("there is no ITEM: NUMBER OF ATOMS before the atoms");
  if (!header.box) input.fail("there is no ITEM: BOX BOUNDS before the atoms");
  Words words;
  split_words(item(input.line()), words);  // ATOMS ...
  MoleculeFrame frame;
  frame.step = header.step;
  DumpAtoms atoms(input, std::span(words).subspan(1), *header.atoms, *header.box, settings, frame);
  for (std::size_t i = 0; i < *header.atoms; ++i) {
    need_line(input, fmt::format("atom {} of {}", i + 1, *header.atoms));
    split_words(input.line(), words);
    atoms.add(input, words);
  }
  atoms.finish(input);
  return frame;
}

std::optional<MoleculeFrame> read_lammps_yaml_frame(TextInput& input, ReadSettings& settings) {
  if (!input.next_line_with_text()) return std::nullopt;
  const YamlHeader header = read_yaml_header(input);
  if (!header.atoms) input.fail("there is no natoms: before the atoms");
  if (!header.has_box) input.fail("there is no box: before the atoms");
  const Words columns(header.columns.begin(), header.columns.end());
  MoleculeFrame frame;
  frame.step = header.step;
  DumpAtoms atoms(input, columns, *header.atoms, header.box, settings, frame);
  Words words;
  for (std::size_t i = 0; i < *header.atoms; ++i) {
    need_line(input, fmt::format("atom {} of {}", i + 1, *header.atoms));
    read_row(input, words);
    atoms.add(input, words);
  }
  atoms.finish(input);
  // A run that was cut off may lack the mark of the end.
  if (input.next_line_with_text() && trimmed(input.line()) != "...") input.give_back_line();
  return frame;
}

}  // namespace nanocarbon::molecule
