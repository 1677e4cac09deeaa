// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "nanocarbon/molecule/formats/lammps_data_assembly.h"

namespace nanocarbon::molecule {
namespace {

std::size_t columns_of(AtomStyle style) {
  return 5u + (has_molecule_id(style) ? 1u : 0u) + (has_charge(style) ? 1u : 0u);
}

bool is_integer(std::string_view word) {
  return !word.empty() &&
         word.find_first_not_of("0123456789", word[0] == '-' ? 1 : 0) == std::string_view::npos;
}

// Image flags are whole numbers, and coordinates written by programs rarely all are.
bool has_images(const std::vector<std::string_view>& words, std::size_t columns) {
  return words.size() == columns + 3;
}

AtomStyle guess(const TextInput& input, const std::vector<std::string_view>& words) {
  const auto has = [&](std::size_t columns) { return words.size() == columns || has_images(words, columns); };
  if (has(5)) return AtomStyle::atomic;
  if (has(7)) return AtomStyle::full;
  // Six columns: "id type q x y z" or "id molecule type x y z". A charge is written with a point, a type
  // never.
  if (has(6)) return is_integer(words[2]) ? AtomStyle::molecular : AtomStyle::charge;
  input.fail(fmt::format(
      "an atom with {} columns is of no known style (atomic, charge, bond, angle, molecular, full)",
      words.size()));
}

}  // namespace

AtomColumns::AtomColumns(const TextInput& input, std::string_view comment, std::optional<AtomStyle> given)
    : style_(given) {
  std::vector<std::string_view> words;
  split_words(comment, words);
  if (style_ || words.empty()) return;
  style_ = atom_style_from_name(words[0]);
  if (!style_)
    input.fail(
        fmt::format("atom style '{}' is not supported (atomic, charge, bond, angle, molecular, full are)",
                    words[0].substr(0, 40)));
}

LammpsAtom AtomColumns::parse(const TextInput& input, const std::vector<std::string_view>& words) {
  if (!style_) style_ = guess(input, words);
  const std::size_t columns = columns_of(*style_);
  if (words.size() != columns && !has_images(words, columns))
    input.fail(fmt::format("expected {} or {} columns for an atom of style {}, found {}", columns,
                           columns + 3, name(*style_), words.size()));
  LammpsAtom atom{input.integer(words[0], "an atom-ID"),
                  words[has_molecule_id(*style_) ? 2 : 1],
                  Vec3::Zero(),
                  {0, 0, 0},
                  input.number()};
  if (atom.id <= 0) input.fail(fmt::format("the atom-ID {} is not above zero", atom.id));
  for (int d = 0; d < 3; ++d) {
    const std::size_t axis = static_cast<std::size_t>(d);
    atom.position[d] = input.coordinate(words[columns - 3 + axis], "a coordinate");
    if (!has_images(words, columns)) continue;
    const std::int64_t image = input.integer(words[columns + axis], "an image flag");
    if (image < -1000000 || image > 1000000)
      input.fail(fmt::format("the image flag {} is out of bounds", image));
    atom.image[axis] = static_cast<std::int32_t>(image);
  }
  return atom;
}

}  // namespace nanocarbon::molecule
