// SPDX-License-Identifier: GPL-2.0-or-later
// JSON that is written while it is made: lists as long as a molecule are never in memory as a tree.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace nanocarbon::analysis {

//! \brief Puts a value after another into a stream, each member of an object and each item of a list on a line of its own.
//! \details A small value that is given whole is one line. Text that is no UTF-8 (names of files may be any bytes) has
//! its faulty bytes replaced; numbers that JSON does not know are null.
class JsonWriter {
 public:
  explicit JsonWriter(std::ostream& out) : out_(out) {}
  JsonWriter(const JsonWriter&) = delete;
  JsonWriter& operator=(const JsonWriter&) = delete;

  void begin_object() { begin('{'); }
  void begin_list() { begin('['); }
  //! Ends the object or list begun last.
  void end();
  //! The name of the next value, within an object.
  void key(std::string_view name);
  void value(const nlohmann::ordered_json& whole);
  //! A list of numbers in one line.
  void numbers(std::span<const std::int64_t> list);
  //! To be called at the end; not done by a destructor, because the stream may throw.
  void flush();

 private:
  struct Level {
    char end;
    bool empty;
  };
  void begin(char bracket);
  void start_value();
  void start_line();

  std::ostream& out_;
  fmt::memory_buffer buffer_;
  std::vector<Level> levels_;
  bool after_key_ = false;
};

}  // namespace nanocarbon::analysis
