// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/lammps_data_reader.h"

#include <fmt/format.h>

#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/formats/lammps_data_assembly.h"

namespace nanocarbon::molecule {
namespace {

using Words = std::vector<std::string_view>;

struct Line {
  std::string_view text;     // without comment and blanks at the ends
  std::string_view comment;  // what follows the first '#'
};

Line split_comment(std::string_view line) {
  const std::size_t hash = line.find('#');
  if (hash == std::string_view::npos) return {trimmed(line), {}};
  return {trimmed(line.substr(0, hash)), trimmed(line.substr(hash + 1))};
}

// Within sections a line may begin with a letter, where types have labels, but then holds numbers. Names that any
// file may have need no blank line before them, as for LAMMPS itself.
bool is_section_name(std::string_view text, bool after_blank) {
  const bool letter = (text[0] >= 'A' && text[0] <= 'Z') || (text[0] >= 'a' && text[0] <= 'z');
  if (!letter) return false;
  for (const std::string_view name : {"Atoms", "Masses", "Velocities", "Bonds", "Angles", "Dihedrals",
                                      "Impropers", "Ellipsoids", "Lines", "Triangles", "Bodies"})
    if (text == name) return true;
  if (text.ends_with(" Coeffs") || text.ends_with(" Type Labels")) return true;
  return after_blank && text.find_first_of("0123456789") == std::string_view::npos;
}

bool ends_with(const Words& words, std::initializer_list<std::string_view> end) {
  return words.size() >= end.size() &&
         std::equal(end.begin(), end.end(), words.end() - static_cast<long>(end.size()));
}

void parse_bounds(const TextInput& input, const Words& words, int d, LammpsFile& file) {
  if (words.size() != 4) input.fail("expected 'lo hi' and their names");
  const double low = input.coordinate(words[0], "the lower bound"),
               high = input.coordinate(words[1], "the upper bound");
  if (!(high > low)) input.fail(fmt::format("the box has no extent here: {} to {}", low, high));
  file.box.origin[d] = low;
  file.box.vectors(d, d) = high - low;
}

void parse_general_vector(const TextInput& input, const Words& words, Eigen::Ref<Vec3> vector) {
  for (int k = 0; k < 3; ++k)
    vector[k] = input.coordinate(words[static_cast<std::size_t>(k)], "a box vector");
}

// The first line of what LAMMPS writes tells the units that the script had: "..., timestep = 0, units = real".
void check_units(const TextInput& input) {
  constexpr std::string_view before = "units = ";
  const std::string_view line = trimmed(input.line());
  const std::size_t at = line.find(before);
  if (!line.starts_with("LAMMPS") || at == std::string_view::npos) return;
  Words words;
  split_words(line.substr(at + before.size()), words);
  if (words.empty() || words[0] == "metal" || words[0] == "real") return;
  throw UserError(Failure::unsuitable,
                  fmt::format("{}:1: the file has units {} by its first line; lengths must be in Angstrom "
                              "(units metal or real)",
                              input.name(), shown(words[0])));
}

// One line before the first section. Counts and bounds that play no part here are passed over.
void parse_header(const TextInput& input, const Words& words, LammpsFile& file) {
  if (words.size() == 2 && words[1] == "atoms") {
    file.atom_count = input.count(words[0], "atoms");
  } else if (ends_with(words, {"atom", "types"})) {
    file.type_count = input.count(words[0], "atom types");
  } else if (words.size() == 2 && words[1] == "bonds") {
    file.bond_count = input.count(words[0], "bonds");
  } else if (ends_with(words, {"xlo", "xhi"})) {
    parse_bounds(input, words, 0, file);
  } else if (ends_with(words, {"ylo", "yhi"})) {
    parse_bounds(input, words, 1, file);
  } else if (ends_with(words, {"zlo", "zhi"})) {
    parse_bounds(input, words, 2, file);
  } else if (ends_with(words, {"xy", "xz", "yz"}) && words.size() == 6) {
    file.box.vectors(0, 1) = input.coordinate(words[0], "a tilt");
    file.box.vectors(0, 2) = input.coordinate(words[1], "a tilt");
    file.box.vectors(1, 2) = input.coordinate(words[2], "a tilt");
  } else if (words.size() == 4 && words[3].ends_with("vec")) {
    if (words[3] == "avec") parse_general_vector(input, words, file.box.vectors.col(0));
    if (words[3] == "bvec") parse_general_vector(input, words, file.box.vectors.col(1));
    if (words[3] == "cvec") parse_general_vector(input, words, file.box.vectors.col(2));
  } else if (ends_with(words, {"abc", "origin"}) && words.size() == 5) {
    parse_general_vector(input, words, file.box.origin);
  }
}

// "boundary p p f" in a comment.
void parse_boundary(std::string_view comment, LammpsFile& file) {
  Words words;
  split_words(comment, words);
  if (words.size() != 4 || words[0] != "boundary") return;
  std::array<bool, 3> periodic;
  for (std::size_t d = 0; d < 3; ++d) periodic[d] = words[d + 1] == "p";
  file.boundary = periodic;
}

std::int64_t type_number(const TextInput& input, std::string_view word, const LammpsFile& file) {
  if (const auto label = file.labels.find(word); label != file.labels.end()) return label->second;
  return input.integer(word, "an atom type or its label");
}

void parse_mass(const TextInput& input, const Words& words, std::string_view comment, LammpsFile& file) {
  if (words.size() < 2) input.fail("expected an atom type and its mass");
  LammpsType& type = file.types[type_number(input, words[0], file)];
  type.mass = input.real(words[1], "a mass");
  if (comment.find_first_of(" \t") == std::string_view::npos) type.comment = comment;
}

void parse_type_label(const TextInput& input, const Words& words, LammpsFile& file) {
  if (words.size() != 2) input.fail("expected an atom type and its label");
  const std::int64_t type = input.integer(words[0], "an atom type");
  file.types[type].label = words[1];
  if (!file.labels.emplace(words[1], type).second)
    input.fail(fmt::format("the label '{}' is also that of another type", shown(words[1])));
}

void parse_bond(const TextInput& input, const Words& words, LammpsFile& file) {
  if (words.size() < 4) input.fail("expected a bond's number, type and two atoms");
  file.bonds.push_back(
      {input.integer(words[2], "an atom-ID"), input.integer(words[3], "an atom-ID"), input.number()});
}

enum class Section { header, atoms, masses, bonds, labels, other };

Section section_of(std::string_view name) {
  if (name == "Atoms") return Section::atoms;
  if (name == "Masses") return Section::masses;
  if (name == "Bonds") return Section::bonds;
  if (name == "Atom Type Labels") return Section::labels;
  return Section::other;
}

LammpsFile parse(TextInput& input, const ReadSettings& settings) {
  LammpsFile file;
  Section section = Section::header;
  std::optional<AtomColumns> columns;
  Words words;
  bool after_blank = true;
  // LAMMPS passes over the first line whatever it holds.
  if (input.next_line()) check_units(input);
  while (input.next_line()) {
    const Line line = split_comment(input.line());
    if (line.text.empty()) {
      after_blank = after_blank || line.comment.empty();
      if (section == Section::header) parse_boundary(line.comment, file);
      continue;
    }
    if (is_section_name(line.text, after_blank)) {
      section = section_of(line.text);
      if (section == Section::atoms) {
        if (columns) input.fail("there is more than one Atoms section");
        columns.emplace(line.comment, settings.atom_style, file.type_count, file.labels);
        file.atoms.reserve(room_for(file.atom_count));
      }
      after_blank = true;  // LAMMPS wants a blank line here, others leave it out
      continue;
    }
    after_blank = false;
    if (section == Section::other) continue;
    split_words(line.text, words);
    if (section == Section::header) parse_header(input, words, file);
    if (section == Section::atoms) file.atoms.push_back(columns->parse(input, words));
    if (section == Section::masses) parse_mass(input, words, line.comment, file);
    if (section == Section::bonds) parse_bond(input, words, file);
    if (section == Section::labels) parse_type_label(input, words, file);
  }
  if (!columns) input.fail_at(input.number(), "the file has no Atoms section; is it a LAMMPS data file?");
  columns->finish(input, file.atoms);
  return file;
}

}  // namespace

MoleculeFrame read_lammps_data(TextInput& input, ReadSettings& settings) {
  return assemble(input, parse(input, settings), settings);
}

}  // namespace nanocarbon::molecule
