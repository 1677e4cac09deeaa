// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/atom_columns.h"

#include <fmt/format.h>

#include <algorithm>

#include "nanocarbon/core/error.h"

namespace nanocarbon::molecule {

std::optional<AtomColumns::Style> AtomColumns::style_named(std::string_view name) {
  // As in LAMMPS's documentation of read_data: name, columns of the type and x, number of columns.
  static constexpr Style styles[] = {
      {"atomic", 1, 2, 5},       {"charge", 1, 3, 6},
      {"bond", 2, 3, 6},         {"angle", 2, 3, 6},
      {"molecular", 2, 3, 6},    {"full", 2, 4, 7},
      {"amoeba", 2, 4, 7},       {"body", 1, 4, 7},
      {"bpm/sphere", 2, 5, 8},   {"dielectric", 1, 3, 6, true},
      {"dipole", 1, 3, 9},       {"dpd", 1, 3, 6},
      {"edpd", 1, 4, 7},         {"electron", 1, 5, 8},
      {"ellipsoid", 1, 4, 7},    {"hybrid", 1, 2, 5, true},
      {"line", 2, 5, 8},         {"mdpd", 1, 3, 6},
      {"mesont", 2, 8, 11},      {"oxdna", 2, 3, 6, true},
      {"peri", 1, 4, 7},         {"rheo", 1, 4, 7},
      {"rheo/thermal", 1, 5, 8}, {"smd", 1, 10, 13},
      {"sph", 1, 5, 8},          {"sphere", 1, 4, 7},
      {"spin", 1, 2, 9},         {"tdpd", 1, 2, 5, true},
      {"template", 2, 5, 8},     {"tri", 2, 5, 8},
      {"wavepacket", 1, 8, 11},
  };
  const auto found =
      std::find_if(std::begin(styles), std::end(styles), [&](const Style& s) { return s.name == name; });
  return found == std::end(styles) ? std::nullopt : std::optional(*found);
}

AtomColumns::AtomColumns(std::string_view comment, std::string_view given, std::size_t types,
                         const TypeLabels& labels)
    : types_(types), labels_(labels) {
  if (!given.empty()) {
    style_ = style_named(given);
    if (!style_)
      throw UserError(Failure::usage,
                      fmt::format("--atom-style: '{}' is not a LAMMPS atom style that can be read here "
                                  "(atomic, charge, molecular, full, sphere, hybrid, ... can)",
                                  shown(given)));
    return;
  }
  std::vector<std::string_view> words;
  split_words(comment, words);
  if (!words.empty()) style_ = style_named(words[0]);
}

std::optional<std::int64_t> AtomColumns::find_type(std::string_view word) const {
  std::int64_t type = 0;
  if (parse_integer(word, type))
    return type >= 1 && type <= static_cast<std::int64_t>(types_) ? std::optional(type) : std::nullopt;
  const auto label = labels_.find(word);
  return label == labels_.end() ? std::nullopt : std::optional(label->second);
}

std::int64_t AtomColumns::type_of(const TextInput& input, std::string_view word) const {
  if (const auto type = find_type(word)) return *type;
  input.fail(
      fmt::format("'{}' is not one of the file's {} atom types{}", shown(word), types_,
                  style_ ? fmt::format(" (atom style {}; --atom-style sets another)", style_->name) : ""));
}

AtomColumns::Style AtomColumns::guess(const TextInput& input, const std::vector<std::string_view>& words) {
  std::size_t columns = words.size();
  const auto is_integer = [&](std::size_t k) {
    std::int64_t ignored = 0;
    return parse_integer(words[k], ignored);
  };
  if (columns >= 8 && is_integer(columns - 1) && is_integer(columns - 2) && is_integer(columns - 3))
    columns -= 3;
  if (columns == 5) return *style_named("atomic");
  if (columns == 7) return *style_named("full");
  if (columns == 6) {
    third_in_doubt_ = true;
    return *style_named("charge");
  }
  input.fail(
      fmt::format("the atom style cannot be told from {} columns: give it with --atom-style", words.size()));
}

LammpsAtom AtomColumns::parse(const TextInput& input, const std::vector<std::string_view>& words) {
  if (!style_) style_ = guess(input, words);
  const std::size_t columns = style_->columns;
  const bool images = !style_->more && words.size() == columns + 3;
  if (words.size() != columns && !images && !(style_->more && words.size() > columns))
    input.fail(fmt::format(
        "expected {} or {} columns for an atom of style {}, found {} (--atom-style sets another style)",
        columns, columns + 3, style_->name, words.size()));
  LammpsAtom atom{input.integer(words[0], "an atom-ID"),
                  0,
                  Vec3::Zero(),
                  {0, 0, 0},
                  static_cast<std::uint32_t>(input.number())};
  if (atom.id <= 0) input.fail(fmt::format("the atom ID {} is not above zero", atom.id));
  if (third_in_doubt_) {
    const auto type = find_type(words[2]);
    if (type) third_as_type_.push_back(*type);
    third_in_doubt_ = type.has_value();
    atom.type = find_type(words[1]).value_or(0);
  } else {
    atom.type = type_of(input, words[style_->type]);
  }
  for (std::size_t d = 0; d < 3; ++d) {
    atom.position[static_cast<int>(d)] = input.coordinate(words[style_->x + d], "a coordinate");
    if (!images) continue;
    const std::int64_t image = input.integer(words[columns + d], "an image flag");
    if (image < -1000000 || image > 1000000)
      input.fail(fmt::format("the image flag {} is out of bounds", image));
    atom.image[d] = static_cast<std::int32_t>(image);
  }
  return atom;
}

void AtomColumns::finish(const TextInput& input, std::vector<LammpsAtom>& atoms) const {
  if (third_in_doubt_) {
    for (std::size_t i = 0; i < atoms.size(); ++i) atoms[i].type = third_as_type_[i];
    return;
  }
  for (const LammpsAtom& atom : atoms)
    if (atom.type == 0)
      input.fail_at(atom.line,
                    "neither the second nor the third column is an atom type in every line: give the atom "
                    "style with --atom-style");
}

}  // namespace nanocarbon::molecule
