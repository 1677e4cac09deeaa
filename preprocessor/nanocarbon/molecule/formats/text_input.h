// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "nanocarbon/core/text_numbers.h"
#include "nanocarbon/molecule/formats/byte_source.h"

namespace nanocarbon::molecule {

//! \brief Text read line by line, checked, whose errors name the file, the line and what stands there.
//! \details Only a part of the text is in memory at a time. Line ends may be those of any system; a byte order
//! mark is passed over.
class TextInput {
 public:
  //! \param name for messages
  //! \throw UserError as the source
  TextInput(ByteSource source, std::string name);

  //! \brief Goes to the next line; false at the end.
  //! \throw UserError (malformed) for a line of more than 16 MiB, which no file of atoms has; as the source
  bool next_line();
  //! Goes to the next line that is not blank; false at the end.
  bool next_line_with_text();
  //! Makes the current line the next one again.
  void give_back_line();
  //! Without its end; valid until the next line is asked for.
  std::string_view line() const { return std::string_view(buffer_).substr(line_begin_, line_size_); }
  //! Number of the current line, from 1.
  std::size_t number() const { return number_; }
  const std::string& name() const { return name_; }

  //! The beginning of the text, as far as it is in memory before the first line: 64 KiB or all there is.
  std::string_view head() const { return std::string_view(buffer_).substr(next_, filled_ - next_); }
  //! \brief All that follows the current line.
  //! \throw UserError (malformed) where that is more than said
  std::string rest(std::size_t most);

  //! \throw UserError (malformed) "file:line: message", and what the line holds
  [[noreturn]] void fail(const std::string& message) const;
  //! The same for a line that has passed, without what it holds.
  [[noreturn]] void fail_at(std::size_t line_number, const std::string& message) const;

  //! A whole token as a finite number; exponents may be Fortran's (1.5D-01).
  //! \throw UserError (malformed) that says what was expected
  double real(std::string_view token, std::string_view what) const;
  //! A number whose size is possible for a coordinate: at most 1e9 Angstrom.
  double coordinate(std::string_view token, std::string_view what) const;
  std::int64_t integer(std::string_view token, std::string_view what) const;
  //! A number of things: from 0 to what an index can hold.
  std::size_t count(std::string_view token, std::string_view what) const;

 private:
  bool fill();

  ByteSource source_;
  std::string name_;
  std::string buffer_;
  std::size_t filled_ = 0;  // bytes of the buffer that hold text
  std::size_t next_ = 0;    // begin of the next line
  std::size_t line_begin_ = 0, line_size_ = 0;
  std::size_t number_ = 0;
  char line_end_ = '\n';
  bool at_end_ = false;
};

//! The words of a text between blanks, into a vector that is reused.
void split_words(std::string_view text, std::vector<std::string_view>& words);

//! The text without blanks at both ends.
std::string_view trimmed(std::string_view text);

//! The text with A to Z in lower case.
std::string lower_case(std::string_view text);

//! A whole number and nothing else, or false.
bool parse_integer(std::string_view token, std::int64_t& value);
//! A number and nothing else (finite or not), also with Fortran's exponents, or false.
bool parse_real(std::string_view token, double& value);

}  // namespace nanocarbon::molecule
