// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <ostream>

namespace nanocarbon::molecule {

//! Formats into memory and passes it to a stream in large blocks: millions of atoms in a second or two.
class TextOutput {
 public:
  explicit TextOutput(std::ostream& out) : out_(out) {}
  TextOutput(const TextOutput&) = delete;
  TextOutput& operator=(const TextOutput&) = delete;

  template <typename... Arguments>
  void print(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Arguments>(arguments)...);
    if (buffer_.size() > block) flush();
  }

  //! To be called at the end; not done by a destructor, because the stream may throw.
  void flush() {
    out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
  }

 private:
  static constexpr std::size_t block = std::size_t{1} << 18;
  std::ostream& out_;
  fmt::memory_buffer buffer_;
};

}  // namespace nanocarbon::molecule
