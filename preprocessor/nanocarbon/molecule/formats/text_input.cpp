// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/text_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "nanocarbon/core/error.h"

namespace nanocarbon::molecule {
namespace {

constexpr std::size_t first_block = std::size_t{1} << 16, block = std::size_t{1} << 20;
constexpr std::size_t longest_line = std::size_t{1} << 24;

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\r' || c == '\n' || c == '\0';
}

}  // namespace

TextInput::TextInput(ByteSource source, std::string name)
    : source_(std::move(source)), name_(std::move(name)), buffer_(first_block, '\0') {
  while (filled_ < buffer_.size() && !at_end_) fill();
  if (head().starts_with("\xef\xbb\xbf")) next_ = 3;
  const std::size_t end = head().find_first_of("\r\n");
  if (end != std::string_view::npos && head()[end] == '\r' && head().find('\n') == std::string_view::npos)
    line_end_ = '\r';
}

// One read into what is free at the end of the buffer.
bool TextInput::fill() {
  const std::size_t count = source_(buffer_.data() + filled_, buffer_.size() - filled_);
  filled_ += count;
  at_end_ = count == 0;
  return !at_end_;
}

bool TextInput::next_line() {
  std::size_t searched = next_;
  for (;;) {
    const void* found =
        searched < filled_ ? std::memchr(buffer_.data() + searched, line_end_, filled_ - searched) : nullptr;
    if (found != nullptr) {
      line_begin_ = next_;
      line_size_ = static_cast<std::size_t>(static_cast<const char*>(found) - buffer_.data()) - next_;
      next_ += line_size_ + 1;
      break;
    }
    if (at_end_) {
      if (next_ >= filled_) return false;
      line_begin_ = next_;
      line_size_ = filled_ - next_;
      next_ = filled_;
      break;
    }
    // The current line's beginning moves to the front of the buffer, and more follows.
    const std::size_t kept = filled_ - next_;
    if (kept > longest_line) fail_at(number_ + 1, "the line is longer than 16 MiB; is this a file of atoms?");
    std::memmove(buffer_.data(), buffer_.data() + next_, kept);
    filled_ = searched = kept;
    next_ = line_begin_ = line_size_ = 0;
    if (buffer_.size() < std::max(block, 2 * kept)) buffer_.resize(std::max(block, 2 * kept));
    fill();
  }
  ++number_;
  return true;
}

bool TextInput::next_line_with_text() {
  while (next_line())
    if (!trimmed(line()).empty()) return true;
  return false;
}

void TextInput::give_back_line() {
  next_ = line_begin_;
  --number_;
}

std::string TextInput::rest(std::size_t most) {
  std::string text(buffer_, next_, filled_ - next_);
  next_ = line_begin_ = filled_ = line_size_ = 0;
  while (fill()) {
    text.append(buffer_, 0, filled_);
    filled_ = 0;
    if (text.size() > most)
      throw UserError(Failure::malformed,
                      fmt::format("{}: the file is larger than {} MiB; this format is for small structures",
                                  name_, most >> 20));
  }
  return text;
}

void TextInput::fail(const std::string& message) const {
  fail_at(number_, fmt::format("{}; the line is \"{}\"", message, shown(trimmed(line()))));
}

void TextInput::fail_at(std::size_t line_number, const std::string& message) const {
  throw UserError(Failure::malformed, fmt::format("{}:{}: {}", name_, line_number, message));
}

double TextInput::real(std::string_view token, std::string_view what) const {
  double value = 0.0;
  if (!parse_real(token, value) || !std::isfinite(value))
    fail(fmt::format("expected {} (a finite number), found '{}'", what, shown(token)));
  return value;
}

double TextInput::coordinate(std::string_view token, std::string_view what) const {
  const double value = real(token, what);
  if (std::abs(value) > 1e9)
    fail(fmt::format("{} is {} Angstrom, which is out of bounds (1e9)", what, value));
  return value;
}

std::int64_t TextInput::integer(std::string_view token, std::string_view what) const {
  std::int64_t value = 0;
  if (!parse_integer(token, value))
    fail(fmt::format("expected {} (a whole number), found '{}'", what, shown(token)));
  return value;
}

std::size_t TextInput::count(std::string_view token, std::string_view what) const {
  const std::int64_t number = integer(token, fmt::format("the number of {}", what));
  if (number < 0 || number >= 0xffffffff) fail(fmt::format("there cannot be {} {}", number, what));
  return static_cast<std::size_t>(number);
}

void split_words(std::string_view text, std::vector<std::string_view>& words) {
  words.clear();
  std::size_t i = 0;
  while (i < text.size()) {
    while (i < text.size() && is_blank(text[i])) ++i;
    const std::size_t begin = i;
    while (i < text.size() && !is_blank(text[i])) ++i;
    if (i > begin) words.push_back(text.substr(begin, i - begin));
  }
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

bool parse_integer(std::string_view token, std::int64_t& value) {
  return read_integer(token, value) == NumberToken::number;
}

bool parse_real(std::string_view token, double& value) {
  if (read_real(token, value) == NumberToken::number) return true;
  const std::size_t exponent = token.find_first_of("dD");
  if (exponent == std::string_view::npos || token.size() > 60) return false;
  std::string with_e(token);
  with_e[exponent] = 'e';
  return read_real(with_e, value) == NumberToken::number;
}

}  // namespace nanocarbon::molecule
