// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "nanocarbon/mesh/parsing/number_words.h"

namespace nanocarbon::mesh {

//! \throw UserError (malformed): "file:line: what; remedy"
[[noreturn]] void fail_at_line(const std::string& file, std::size_t line, const std::string& what,
                               const std::string& remedy = "repair the file or export it again");

//! Walks over a text file line by line and word by word, keeping the place for error messages. Lines end with
//! LF, CR LF or (in a file without any LF) CR. Numbers are read as in core/text_numbers.h.
class TextScanner {
 public:
  struct Syntax {
    char comment = '#';            //!< from here to the end of the line is skipped; '\0' for none
    bool continuation = false;     //!< a backslash at the end of a line joins the next one to it
    std::size_t lines_before = 0;  //!< lines of the file that come before the text
  };

  //! \param file name for messages
  TextScanner(std::string_view text, std::string file, Syntax syntax);

  //! Goes to the next line that is not blank.
  //! \return false at the end of the text
  bool next_line();

  //! The next word of the line; empty at its end.
  std::string_view word();
  //! Puts back the last characters of the word that was read last.
  void give_back(std::size_t characters) { line_ = {line_.data() - characters, line_.size() + characters}; }
  //! What is left of the line.
  std::string_view rest() const { return line_; }
  bool at_line_end();

  //! \brief The next word as a finite coordinate.
  //! \throw UserError (malformed) when there is none, or it is not a number, not finite, or beyond what can be
  //! squared
  double coordinate(const char* what);
  //! The next word as an integer from 0 on.
  //! \throw UserError (malformed)
  std::uint64_t count(const char* what);
  //! The next word as an integer.
  //! \throw UserError (malformed)
  std::int64_t integer(const char* what);

  std::size_t line_number() const { return line_number_; }
  //! Offset in the text of the first byte after the current line.
  std::size_t next_line_offset() const { return next_; }
  std::size_t remaining() const { return text_.size() - next_; }
  const std::string& file() const { return file_; }

  //! Fails at the current line.
  [[noreturn]] void fail(const std::string& what, const std::string& remedy) const;
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::string_view number_word(const char* what);  // fails where there is none

  std::string_view text_;
  std::string file_;
  Syntax syntax_;
  char line_end_;
  std::size_t next_ = 0;
  std::size_t line_number_ = 0;
  std::size_t lines_in_current_ = 1;
  std::string_view line_;
};

}  // namespace nanocarbon::mesh
