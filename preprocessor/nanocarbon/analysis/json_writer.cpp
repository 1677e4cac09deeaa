// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/analysis/json_writer.h"

#include <nlohmann/json.hpp>
#include <ostream>

namespace nanocarbon::analysis {
namespace {

std::string dumped(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

void JsonWriter::start_line() {
  constexpr std::size_t block = std::size_t{1} << 18;
  if (buffer_.size() > block) flush();
  buffer_.push_back('\n');
  for (std::size_t level = 0; level < levels_.size(); ++level)
    fmt::format_to(std::back_inserter(buffer_), "  ");
}

void JsonWriter::start_value() {
  if (after_key_) {
    after_key_ = false;
    return;
  }
  if (levels_.empty()) return;
  if (!levels_.back().empty) buffer_.push_back(',');
  levels_.back().empty = false;
  start_line();
}

void JsonWriter::begin(char bracket) {
  start_value();
  buffer_.push_back(bracket);
  levels_.push_back({bracket == '{' ? '}' : ']', true});
}

void JsonWriter::end() {
  const Level level = levels_.back();
  levels_.pop_back();
  if (!level.empty) start_line();
  buffer_.push_back(level.end);
}

void JsonWriter::key(std::string_view name) {
  start_value();
  fmt::format_to(std::back_inserter(buffer_), "{}: ", dumped(std::string(name)));
  after_key_ = true;
}

void JsonWriter::value(const nlohmann::ordered_json& whole) {
  start_value();
  fmt::format_to(std::back_inserter(buffer_), "{}", dumped(whole));
}

void JsonWriter::numbers(std::span<const std::int64_t> list) {
  start_value();
  buffer_.push_back('[');
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (k > 0) buffer_.push_back(',');
    fmt::format_to(std::back_inserter(buffer_), "{}", list[k]);
  }
  buffer_.push_back(']');
}

void JsonWriter::flush() {
  out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  buffer_.clear();
}

}  // namespace nanocarbon::analysis
