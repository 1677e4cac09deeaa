// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/poscar_reader.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "nanocarbon/core/error.h"

namespace nanocarbon::molecule {
namespace {

using Words = std::vector<std::string_view>;

Words next_words(TextInput& input, std::string_view what) {
  if (!input.next_line()) input.fail_at(input.number(), fmt::format("the file ends before {}", what));
  Words words;
  const std::string_view line = input.line();
  split_words(line.substr(0, line.find_first_of("#!")), words);
  return words;
}

Vec3 three_numbers(const TextInput& input, const Words& words, std::string_view what) {
  if (words.size() < 3) input.fail(fmt::format("expected {} of three numbers", what));
  return {input.coordinate(words[0], what), input.coordinate(words[1], what),
          input.coordinate(words[2], what)};
}

//! The factors of x, y and z, after the vectors have been read and scaled.
Vec3 scale_vectors(const TextInput& input, const Words& words, Mat3& vectors) {
  Vec3 factors;
  if (words.size() >= 3) {
    factors = three_numbers(input, words, "the scale");
  } else {
    const double scale = input.coordinate(words[0], "the scale");
    const double inside = std::abs(vectors.determinant());
    factors.setConstant(scale < 0.0 && inside > 0.0 ? std::cbrt(-scale / inside) : scale);
  }
  if (!(factors.minCoeff() > 0.0))
    input.fail("the scale (line 2) must be above zero, or one negative volume");
  vectors = factors.asDiagonal() * vectors;
  return factors;
}

}  // namespace

MoleculeFrame read_poscar(TextInput& input, ReadSettings& settings) {
  next_words(input, "its title");
  Words scale = next_words(input, "the scale");
  if (scale.empty()) input.fail("expected the scale");
  std::vector<std::string> kept(scale.begin(), scale.end());
  Cell cell;
  for (int d = 0; d < 3; ++d)
    cell.vectors.col(d) = three_numbers(input, next_words(input, "the vectors"), "a vector");
  const Vec3 factors = scale_vectors(input, Words(kept.begin(), kept.end()), cell.vectors);

  MoleculeFrame frame;
  frame.molecule.cell = cell_as_read(input, cell, settings);
  SpeciesReader species(settings.types);
  std::vector<Element> elements;
  Words words = next_words(input, "the elements");
  if (words.empty()) input.fail("expected the elements or the numbers of atoms");
  std::int64_t number = 0;
  const bool named = !parse_integer(words[0], number);
  if (named) {
    for (const std::string_view word : words) elements.push_back(species.of_name(input, word));
    words = next_words(input, "the numbers of atoms");
    if (words.size() != elements.size())
      input.fail(fmt::format("expected {} numbers of atoms, one for each element", elements.size()));
  }
  std::vector<std::size_t> counts;
  for (std::size_t k = 0; k < words.size(); ++k) {
    counts.push_back(input.count(words[k], "atoms"));
    if (!named && counts.back() > 0) {
      if (settings.types.empty())
        throw UserError(Failure::unsuitable,
                        fmt::format("{}:{}: the file does not name its elements (VASP 5 does before this "
                                    "line): give them, as in --types C H",
                                    input.name(), input.number()));
      elements.push_back(species.of_name(input, fmt::format("{}", k + 1)));
    } else if (!named) {
      elements.push_back(Element::carbon);
    }
  }
  words = next_words(input, "Direct or Cartesian");
  const auto initial = [&] { return words.empty() ? ' ' : lower_case(words[0])[0]; };
  if (initial() == 's') words = next_words(input, "Direct or Cartesian");
  const bool cartesian = initial() == 'c' || initial() == 'k';
  if (!cartesian && initial() != 'd') input.fail("expected Direct or Cartesian");
  for (std::size_t k = 0; k < counts.size(); ++k)
    for (std::size_t i = 0; i < counts[k]; ++i) {
      const Vec3 p =
          three_numbers(input, next_words(input, fmt::format("atom {}", frame.ids.size() + 1)), "a position");
      frame.molecule.positions.push_back(cartesian ? Vec3(factors.cwiseProduct(p)) : Vec3(cell.vectors * p));
      frame.molecule.elements.push_back(elements[k]);
      frame.ids.push_back(static_cast<std::int64_t>(frame.ids.size()) + 1);
    }
  return frame;
}

}  // namespace nanocarbon::molecule
