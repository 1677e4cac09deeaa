// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/text_input.h"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

#include "nanocarbon/core/error.h"

namespace nanocarbon::molecule {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\r' || c == '\0'; }

// What is shown of a token in a message: short, and nothing that upsets a terminal.
std::string shown(std::string_view token) {
  std::string text(token.substr(0, 40));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f) c = '?';
  return token.size() > 40 ? text + "..." : text;
}

template <typename Number>
bool parse(std::string_view token, Number& value) {
  if (token.size() > 1 && token[0] == '+' && token[1] != '-') token.remove_prefix(1);
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  return error == std::errc() && end == token.data() + token.size();
}

}  // namespace

TextInput::TextInput(const std::filesystem::path& path) : name_(path.string()) {
  const auto unreadable = [&](const std::string& reason) {
    throw UserError(Failure::unreadable, fmt::format("{}: cannot be read: {}", name_, reason));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) unreadable("it is a directory");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) unreadable(errno ? std::strerror(errno) : "it cannot be opened");
  contents_.assign(std::istreambuf_iterator<char>(in), {});
  if (in.bad()) unreadable("read error");
}

TextInput::TextInput(std::istream& in, std::string name)
    : name_(std::move(name)), contents_(std::istreambuf_iterator<char>(in), {}) {}

bool TextInput::next_line() {
  if (next_ >= contents_.size()) return false;
  const std::size_t end = contents_.find('\n', next_);
  line_ = std::string_view(contents_).substr(next_, end == std::string::npos ? end : end - next_);
  next_ = end == std::string::npos ? contents_.size() : end + 1;
  ++number_;
  return true;
}

void TextInput::fail_at(std::size_t line_number, const std::string& message) const {
  throw UserError(Failure::malformed, fmt::format("{}:{}: {}", name_, line_number, message));
}

double TextInput::real(std::string_view token, std::string_view what) const {
  double value = 0.0;
  if (!parse(token, value) || !std::isfinite(value))
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
  if (!parse(token, value)) fail(fmt::format("expected {} (a whole number), found '{}'", what, shown(token)));
  return value;
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

}  // namespace nanocarbon::molecule
