// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/xyz_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "nanocarbon/molecule/formats/distance_warnings.h"
#include "nanocarbon/molecule/formats/xyz_comment.h"

namespace nanocarbon::molecule {
namespace {

using Words = std::vector<std::string_view>;

void check_what_follows(TextInput& input, std::size_t atoms, Words& words) {
  if (!input.next_line_with_text()) return;
  split_words(input.line(), words);
  std::int64_t next = 0;
  if (words.size() != 1 || !parse_integer(words[0], next))
    input.fail(
        fmt::format("the frame ended with the {} atoms that it promised; expected the number of atoms of "
                    "another frame, alone on its line",
                    atoms));
  input.give_back_line();
}

// "1 C 0.0 0.0 1.4": the second word is no number, where x should be, but a name.
bool is_numbered(const Words& words, const XyzColumns& columns) {
  std::int64_t number = 0;
  double coordinate = 0.0;
  return columns.species == 0 && columns.position == 1 && words.size() >= 5 &&
         parse_integer(words[0], number) && !parse_real(words[1], coordinate) &&
         atomic_number_of_label(words[1]).has_value() && parse_real(words[2], coordinate) &&
         parse_real(words[3], coordinate) && parse_real(words[4], coordinate);
}

// A property that is called id is used as such where it tells the atoms apart; whether it does.
bool use_ids(std::vector<std::int64_t> ids, MoleculeFrame& frame) {
  std::vector<std::int64_t> sorted = ids;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return false;
  frame.ids = std::move(ids);
  sort_by_id(frame);
  return true;
}

}  // namespace

std::optional<MoleculeFrame> read_xyz_frame(TextInput& input, ReadSettings& settings) {
  if (!input.next_line_with_text()) return std::nullopt;
  Words words;
  split_words(input.line(), words);
  if (words.size() != 1) input.fail("expected the number of atoms alone on its line");
  const std::size_t atoms = input.count(words[0], "atoms");
  if (!input.next_line()) input.fail("the file ends before the comment line");
  const XyzComment comment = parse_xyz_comment(input, settings);
  const XyzColumns& columns = comment.columns;

  MoleculeFrame frame;
  frame.step = comment.step;
  frame.molecule.cell = comment.cell;
  frame.molecule.positions.reserve(room_for(atoms));
  frame.molecule.elements.reserve(room_for(atoms));
  frame.ids.reserve(room_for(atoms));
  std::vector<std::int64_t> ids;
  SpeciesReader species(settings.types);
  for (std::size_t i = 0; i < atoms; ++i) {
    if (!input.next_line())
      input.fail_at(input.number(), fmt::format("the file ends after {} of {} atoms", i, atoms));
    split_words(input.line(), words);
    if (words.size() < columns.least)
      input.fail(fmt::format("expected at least {} columns for atom {}, found {}", columns.least, i + 1,
                             words.size()));
    if (i == 0 && is_numbered(words, columns))
      input.fail(
          "a number stands before the name of the atom, as in files of Tinker; remove these numbers, so "
          "that each line is NAME X Y Z");
    const std::string_view name = words[columns.species];
    frame.molecule.elements.push_back(columns.atomic_numbers ? species.of_atomic_number(input, name)
                                                             : species.of_name(input, name));
    const std::size_t x = columns.position;
    frame.molecule.positions.emplace_back(input.coordinate(words[x], "x"),
                                          input.coordinate(words[x + 1], "y"),
                                          input.coordinate(words[x + 2], "z"));
    frame.ids.push_back(static_cast<std::int64_t>(i) + 1);
    if (columns.id) ids.push_back(input.integer(words[*columns.id], "an atom-ID"));
  }
  frame.has_ids = columns.id && use_ids(std::move(ids), frame);
  check_what_follows(input, atoms, words);
  if (comment.lattice)
    if (const auto doubt = bonds_through_open_faces(frame.molecule, *comment.lattice))
      frame.warnings.push_back(*doubt);
  return frame;
}

}  // namespace nanocarbon::molecule
