// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/text_numbers.h"

#include <charconv>

namespace nanocarbon {
namespace {

// std::from_chars calls 1e-400 out of range as it does 1e400; the first is as good as zero.
bool is_underflow(std::string_view token) {
  if (token.find_first_of("eE") != token.npos)
    return token.find("e-") != token.npos || token.find("E-") != token.npos;
  return token.substr(0, token.find('.')).find_first_of("123456789") == token.npos;
}

template <typename Number>
std::from_chars_result parse(std::string_view& token, Number& value) {
  if (token.size() > 1 && token[0] == '+' && token[1] != '-') token.remove_prefix(1);
  return std::from_chars(token.data(), token.data() + token.size(), value);
}

}  // namespace

NumberToken read_real(std::string_view token, double& value) {
  const auto [end, error] = parse(token, value);
  if (end != token.data() + token.size()) return NumberToken::not_a_number;
  if (error == std::errc()) return NumberToken::number;
  if (error != std::errc::result_out_of_range) return NumberToken::not_a_number;
  if (!is_underflow(token)) return NumberToken::too_large;
  value = 0.0;
  return NumberToken::number;
}

NumberToken read_integer(std::string_view token, std::int64_t& value) {
  const auto [end, error] = parse(token, value);
  if (end != token.data() + token.size()) return NumberToken::not_a_number;
  if (error == std::errc::result_out_of_range) return NumberToken::too_large;
  return error == std::errc() ? NumberToken::number : NumberToken::not_a_number;
}

std::string shown(std::string_view text, std::size_t most) {
  std::string result(text.substr(0, most));
  for (char& c : result) {
    if (c == '\t') c = ' ';
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f) c = '?';
  }
  return text.size() > most ? result + "..." : result;
}

}  // namespace nanocarbon
