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

// What stands before the positions.
struct Head {
  std::string title;
  Cell cell;                     // as written
  std::optional<Cell> periodic;  // the molecule's
  Vec3 factors = Vec3::Ones();
  std::vector<Element> elements;  // of each kind of atoms
  std::vector<std::size_t> counts;
};

Head read_head(TextInput& input, ReadSettings& settings) {
  Head head;
  next_words(input, "its title");
  head.title = trimmed(input.line());
  Words scale = next_words(input, "the scale");
  if (scale.empty()) input.fail("expected the scale");
  std::vector<std::string> kept(scale.begin(), scale.end());
  for (int d = 0; d < 3; ++d)
    head.cell.vectors.col(d) = three_numbers(input, next_words(input, "the vectors"), "a vector");
  head.factors = scale_vectors(input, Words(kept.begin(), kept.end()), head.cell.vectors);
  head.periodic = cell_as_read(input, head.cell, settings);
  SpeciesReader species(settings.types);
  Words words = next_words(input, "the elements");
  if (words.empty()) input.fail("expected the elements or the numbers of atoms");
  std::int64_t number = 0;
  const bool named = !parse_integer(words[0], number);
  if (named) {
    for (const std::string_view word : words) head.elements.push_back(species.of_name(input, word));
    words = next_words(input, "the numbers of atoms");
    if (words.size() != head.elements.size())
      input.fail(fmt::format("expected {} numbers of atoms, one for each element", head.elements.size()));
  }
  for (std::size_t k = 0; k < words.size(); ++k) {
    head.counts.push_back(input.count(words[k], "atoms"));
    if (!named && head.counts.back() > 0) {
      if (settings.types.empty())
        throw UserError(Failure::unsuitable,
                        fmt::format("{}:{}: the file does not name its elements (VASP 5 does before this "
                                    "line): give them, as in --types C H",
                                    input.name(), input.number()));
      head.elements.push_back(species.of_name(input, fmt::format("{}", k + 1)));
    } else if (!named) {
      head.elements.push_back(Element::carbon);
    }
  }
  return head;
}

// The number at the end of a line "Direct configuration= 7", by which VASP begins each frame of an XDATCAR.
std::optional<std::int64_t> configuration(std::string_view line) {
  if (!lower_case(trimmed(line)).starts_with("direct configuration")) return std::nullopt;
  std::int64_t number = 0;
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos || !parse_integer(trimmed(line.substr(equals + 1)), number)) return 0;
  return number;
}

MoleculeFrame read_positions(TextInput& input, const Head& head, bool cartesian) {
  MoleculeFrame frame;
  frame.molecule.cell = head.periodic;
  frame.has_ids = false;
  for (std::size_t k = 0; k < head.counts.size(); ++k)
    for (std::size_t i = 0; i < head.counts[k]; ++i) {
      const Vec3 p =
          three_numbers(input, next_words(input, fmt::format("atom {}", frame.ids.size() + 1)), "a position");
      frame.molecule.positions.push_back(cartesian ? Vec3(head.factors.cwiseProduct(p))
                                                   : Vec3(head.cell.vectors * p));
      frame.molecule.elements.push_back(head.elements[k]);
      frame.ids.push_back(static_cast<std::int64_t>(frame.ids.size()) + 1);
    }
  return frame;
}

}  // namespace

std::vector<MoleculeFrame> read_poscar(TextInput& input, ReadSettings& settings) {
  Head head = read_head(input, settings);
  Words words = next_words(input, "Direct or Cartesian");
  const auto initial = [&] { return words.empty() ? ' ' : lower_case(words[0])[0]; };
  std::vector<MoleculeFrame> frames;
  std::optional<std::int64_t> number = configuration(input.line());
  if (!number) {
    if (initial() == 's') words = next_words(input, "Direct or Cartesian");
    const bool cartesian = initial() == 'c' || initial() == 'k';
    if (!cartesian && initial() != 'd' && initial() != 'f')  // fractional, for VASP the same as direct
      input.fail("expected Direct or Cartesian");
    frames.push_back(read_positions(input, head, cartesian));
    return frames;
  }
  for (;;) {
    frames.push_back(read_positions(input, head, false));
    frames.back().step = number;
    if (!input.next_line_with_text()) return frames;
    if (trimmed(input.line()) == head.title) {  // where the cell changes, all of it comes again
      input.give_back_line();
      head = read_head(input, settings);
      if (!input.next_line()) input.fail_at(input.number(), "the file ends before the positions");
    }
    number = configuration(input.line());
    if (!number) input.fail("expected Direct configuration= and its number");
  }
}

}  // namespace nanocarbon::molecule
