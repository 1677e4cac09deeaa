// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/parsing/text_scanner.h"

#include <fmt/format.h>

#include "nanocarbon/core/error.h"
#include "nanocarbon/core/text_numbers.h"

namespace nanocarbon::mesh {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f'; }

}  // namespace

void fail_at_line(const std::string& file, std::size_t line, const std::string& what,
                  const std::string& remedy) {
  throw UserError(Failure::malformed, fmt::format("{}:{}: {}; {}", file, line, what, remedy));
}

TextScanner::TextScanner(std::string_view text, std::string file, Syntax syntax)
    : text_(text), file_(std::move(file)), syntax_(syntax) {
  line_end_ = text.find('\n') == text.npos && text.find('\r') != text.npos ? '\r' : '\n';
  line_number_ = syntax.lines_before;
  lines_in_current_ = 1;
}

bool TextScanner::next_line() {
  while (next_ < text_.size()) {
    line_number_ += lines_in_current_;
    lines_in_current_ = 1;
    const std::size_t begin = next_;
    std::size_t end = std::min(text_.find(line_end_, begin), text_.size());
    while (syntax_.continuation && end < text_.size()) {
      const std::size_t last = end > begin && text_[end - 1] == '\r' ? end - 1 : end;
      if (last == begin || text_[last - 1] != '\\') break;
      end = std::min(text_.find(line_end_, end + 1), text_.size());
      ++lines_in_current_;
    }
    next_ = std::min(end + 1, text_.size());
    line_ = text_.substr(begin, end - begin);
    if (syntax_.comment != '\0') line_ = line_.substr(0, line_.find(syntax_.comment));
    if (!at_line_end()) return true;
  }
  line_ = {};
  return false;
}

bool TextScanner::at_line_end() {
  std::size_t i = 0;
  while (i < line_.size() && (is_blank(line_[i]) || (syntax_.continuation && line_[i] == '\\'))) ++i;
  line_.remove_prefix(i);
  return line_.empty();
}

std::string_view TextScanner::word() {
  if (at_line_end()) return {};
  std::size_t i = 0;
  while (i < line_.size() && !is_blank(line_[i]) && !(syntax_.continuation && line_[i] == '\\')) ++i;
  const std::string_view found = line_.substr(0, i);
  line_.remove_prefix(i);
  return found;
}

double TextScanner::coordinate(const char* what) {
  const std::string_view found = number_word(what);
  double value = 0.0;
  const NumberToken token = read_real(found, value);
  if (token == NumberToken::too_large)
    fail(fmt::format("the {} {} is too large for a number", what, quoted(found)));
  if (token == NumberToken::not_a_number) {
    if (found.find(',') != found.npos)
      fail(fmt::format("the {} {} is not a number", what, quoted(found)),
           "write decimal points instead of commas");
    fail(fmt::format("the {} {} is not a number", what, quoted(found)));
  }
  if (const char* fault = coordinate_fault(value))
    fail(fmt::format("the {} {} {}", what, quoted(found), fault));
  return value;
}

std::string_view TextScanner::number_word(const char* what) {
  const std::string_view found = word();
  if (found.empty()) fail(fmt::format("the {} is missing", what));
  return found;
}

std::int64_t TextScanner::integer(const char* what) {
  const NumberWord read = integer_word(number_word(what), what);
  if (!read.fault.empty()) fail(read.fault);
  return read.value;
}

std::uint64_t TextScanner::count(const char* what) {
  const NumberWord read = count_word(number_word(what), what);
  if (!read.fault.empty()) fail(read.fault);
  return static_cast<std::uint64_t>(read.value);
}

void TextScanner::fail(const std::string& what, const std::string& remedy) const {
  fail_at_line(file_, line_number_, what, remedy);
}

void TextScanner::fail(const std::string& what) const { fail_at_line(file_, line_number_, what); }

}  // namespace nanocarbon::mesh
