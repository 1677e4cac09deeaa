// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/parsing/value_cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "nanocarbon/core/error.h"
#include "nanocarbon/core/text_numbers.h"
#include "nanocarbon/mesh/parsing/number_words.h"
#include "nanocarbon/mesh/parsing/text_scanner.h"

namespace nanocarbon::mesh {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

}  // namespace

ValueCursor::ValueCursor(std::string_view contents, std::string file)
    : contents_(contents), file_(std::move(file)) {}

std::string_view ValueCursor::next_word() const {
  const std::size_t begin = std::min(contents_.find_first_not_of(blanks, at_), contents_.size());
  const std::size_t end = std::min(contents_.find_first_of(blanks, begin), contents_.size());
  return contents_.substr(begin, end - begin);
}

std::string_view ValueCursor::word() {
  const std::string_view found = next_word();
  last_ = static_cast<std::size_t>(found.data() - contents_.data());
  at_ = last_ + found.size();
  return found;
}

std::string_view ValueCursor::line() {
  last_ = at_;
  const std::size_t end = std::min(contents_.find_first_of("\r\n", at_), contents_.size());
  const std::string_view found = contents_.substr(at_, end - at_);
  at_ = end;
  if (at_ < contents_.size() && contents_[at_] == '\r') ++at_;
  if (at_ < contents_.size() && contents_[at_] == '\n') ++at_;
  return found;
}

double ValueCursor::real(const char* what) {
  const std::string_view found = number_word(what);
  double value = 0.0;
  if (read_real(found, value) != NumberToken::number || !std::isfinite(value))
    fail(fmt::format("the {} {} is not a finite number", what, quoted(found)));
  return value;
}

double ValueCursor::coordinate(const char* what) {
  const double value = real(what);
  if (const char* fault = coordinate_fault(value)) fail(fmt::format("the {} {} {}", what, value, fault));
  return value;
}

std::string_view ValueCursor::number_word(const char* what) {
  const std::string_view found = word();
  if (found.empty()) fail(fmt::format("the file ends before the {}", what));
  return found;
}

std::int64_t ValueCursor::integer(const char* what) {
  const NumberWord read = integer_word(number_word(what), what);
  if (!read.fault.empty()) fail(read.fault);
  return read.value;
}

std::uint64_t ValueCursor::count(const char* what) {
  const NumberWord read = count_word(number_word(what), what);
  if (!read.fault.empty()) fail(read.fault);
  return static_cast<std::uint64_t>(read.value);
}

std::string_view ValueCursor::bytes(std::size_t size, const char* what) {
  last_ = at_;
  if (size > remaining())
    fail(fmt::format("the file ends within the {}: {} of {} bytes are there", what, remaining(), size));
  binary_ = true;
  at_ += size;
  return contents_.substr(last_, size);
}

void ValueCursor::fail(const std::string& what) const { fail(what, "repair the file or export it again"); }

void ValueCursor::fail(const std::string& what, const std::string& remedy) const {
  if (binary_)
    throw UserError(Failure::malformed, fmt::format("{}: byte {}: {}; {}", file_, last_, what, remedy));
  const std::string_view before = contents_.substr(0, last_);
  const bool mac = contents_.find('\n') == contents_.npos;
  const auto lines = std::count(before.begin(), before.end(), mac ? '\r' : '\n');
  fail_at_line(file_, static_cast<std::size_t>(lines) + 1, what, remedy);
}

}  // namespace nanocarbon::mesh
