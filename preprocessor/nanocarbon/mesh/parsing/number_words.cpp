// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/parsing/number_words.h"

#include <fmt/format.h>

#include <cmath>

#include "nanocarbon/core/text_numbers.h"

namespace nanocarbon::mesh {

namespace {

constexpr double largest_coordinate = 1e50;  // its sixth power, a squared volume, does not overflow

}  // namespace

const char* coordinate_fault(double value) {
  if (!std::isfinite(value)) return "is not finite";
  if (std::abs(value) > largest_coordinate) return "is larger than 1e50";
  return nullptr;
}

std::string quoted(std::string_view text) { return "'" + shown(text, 30) + "'"; }

NumberWord integer_word(std::string_view word, const char* what) {
  NumberWord read;
  if (read_integer(word, read.value) != NumberToken::number)
    read.fault = fmt::format("the {} {} is not an integer", what, quoted(word));
  return read;
}

NumberWord count_word(std::string_view word, const char* what) {
  NumberWord read = integer_word(word, what);
  if (read.fault.empty() && read.value < 0)
    read.fault = fmt::format("the {} is negative ({})", what, read.value);
  return read;
}

}  // namespace nanocarbon::mesh
