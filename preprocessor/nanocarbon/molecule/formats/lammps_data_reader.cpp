// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/formats/lammps_data.h"
#include "nanocarbon/molecule/formats/lammps_data_assembly.h"
#include "nanocarbon/molecule/formats/text_input.h"

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

// Within sections a line may begin with a letter, where types have labels, but then holds numbers.
bool is_section_name(std::string_view text) {
  const bool letter = (text[0] >= 'A' && text[0] <= 'Z') || (text[0] >= 'a' && text[0] <= 'z');
  return letter && (text.ends_with("Coeffs") || text.find_first_of("0123456789") == std::string_view::npos);
}

bool ends_with(const Words& words, std::initializer_list<std::string_view> end) {
  return words.size() >= end.size() &&
         std::equal(end.begin(), end.end(), words.end() - static_cast<long>(end.size()));
}

std::size_t parse_count(const TextInput& input, std::string_view word, std::string_view what) {
  const std::int64_t count = input.integer(word, fmt::format("the number of {}", what));
  if (count < 0 || count >= 0xffffffff) input.fail(fmt::format("there cannot be {} {}", count, what));
  return static_cast<std::size_t>(count);
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

// One line before the first section. Counts and bounds that play no part here are passed over.
void parse_header(const TextInput& input, const Words& words, LammpsFile& file) {
  if (words.size() == 2 && words[1] == "atoms") {
    file.atom_count = parse_count(input, words[0], "atoms");
  } else if (ends_with(words, {"atom", "types"})) {
    file.type_count = parse_count(input, words[0], "atom types");
  } else if (words.size() == 2 && words[1] == "bonds") {
    file.bond_count = parse_count(input, words[0], "bonds");
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

void parse_mass(const TextInput& input, const Words& words, std::string_view comment, LammpsFile& file) {
  if (words.size() < 2) input.fail("expected an atom type and its mass");
  const auto label = file.type_of_label.find(std::string(words[0]));
  LammpsType& type = file.types[label != file.type_of_label.end() ? label->second : std::string(words[0])];
  type.mass = input.real(words[1], "a mass");
  Words comment_words;
  split_words(comment, comment_words);
  if (!comment_words.empty() && !type.element) type.element = element_from_symbol(comment_words[0]);
}

void parse_type_label(const TextInput& input, const Words& words, LammpsFile& file) {
  if (words.size() != 2) input.fail("expected an atom type and its label");
  file.types[std::string(words[0])].element = element_from_symbol(words[1]);
  file.type_of_label[std::string(words[1])] = std::string(words[0]);
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

LammpsFile parse(TextInput& input, const LammpsReadOptions& options) {
  LammpsFile file;
  Section section = Section::header;
  std::optional<AtomColumns> columns;
  Words words;
  bool after_blank = true;
  input.next_line();  // LAMMPS passes over the first line whatever it holds
  while (input.next_line()) {
    const Line line = split_comment(input.line());
    if (line.text.empty()) {
      after_blank = after_blank || line.comment.empty();
      if (section == Section::header) parse_boundary(line.comment, file);
      continue;
    }
    if (after_blank && is_section_name(line.text)) {
      section = section_of(line.text);
      if (section == Section::atoms) {
        if (columns) input.fail("there is more than one Atoms section");
        columns.emplace(input, line.comment, options.atom_style);
        file.atoms.reserve(std::min(file.atom_count, input.size() / 10 + 1));
      }
      after_blank = true;  // LAMMPS wants a blank line here, others leave it out
      continue;
    }
    after_blank = false;
    split_words(line.text, words);
    if (section == Section::header) parse_header(input, words, file);
    if (section == Section::atoms) file.atoms.push_back(columns->parse(input, words));
    if (section == Section::masses) parse_mass(input, words, line.comment, file);
    if (section == Section::bonds) parse_bond(input, words, file);
    if (section == Section::labels) parse_type_label(input, words, file);
  }
  if (!columns) input.fail("the file has no Atoms section; is it a LAMMPS data file?");
  file.atom_style = columns->style();
  return file;
}

LammpsData read(TextInput& input, const LammpsReadOptions& options) {
  return assemble(input, parse(input, options), options);
}

}  // namespace

LammpsData read_lammps_data(const std::filesystem::path& path, const LammpsReadOptions& options) {
  TextInput input(path);
  return read(input, options);
}

LammpsData read_lammps_data(std::istream& in, const std::string& name, const LammpsReadOptions& options) {
  TextInput input(in, name);
  return read(input, options);
}

}  // namespace nanocarbon::molecule
