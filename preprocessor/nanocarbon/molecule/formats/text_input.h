// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace nanocarbon::molecule {

//! \brief A text file read line by line, checked, whose errors name the file and the line.
//! \details The whole file is held in memory; views into it stay valid as long as the object. Line ends may
//! be those of any system.
class TextInput {
 public:
  //! \throw UserError (unreadable) naming the path and the system's reason
  explicit TextInput(const std::filesystem::path& path);
  //! \param name to appear in errors in place of a path
  TextInput(std::istream& in, std::string name);

  //! Goes to the next line; false at the end of the file.
  bool next_line();
  std::string_view line() const { return line_; }
  //! Number of the current line, from 1.
  std::size_t number() const { return number_; }
  std::size_t size() const { return contents_.size(); }

  //! \throw UserError (malformed) "file:line: message"
  [[noreturn]] void fail(const std::string& message) const { fail_at(number_, message); }
  [[noreturn]] void fail_at(std::size_t line_number, const std::string& message) const;

  //! A whole token as a finite number.
  //! \throw UserError (malformed) that says what was expected
  double real(std::string_view token, std::string_view what) const;
  //! A number whose size is possible for a coordinate: at most 1e9 Angstrom.
  double coordinate(std::string_view token, std::string_view what) const;
  std::int64_t integer(std::string_view token, std::string_view what) const;

 private:
  std::string name_;
  std::string contents_;
  std::string_view line_;
  std::size_t next_ = 0;
  std::size_t number_ = 0;
};

//! The words of a text between blanks, into a vector that is reused.
void split_words(std::string_view text, std::vector<std::string_view>& words);

//! The text without blanks at both ends.
std::string_view trimmed(std::string_view text);

}  // namespace nanocarbon::molecule
