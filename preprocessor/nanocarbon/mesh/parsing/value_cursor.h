// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace nanocarbon::mesh {

//! Walks over a file of values that stand anywhere on its lines, with blocks of bytes between them: VTK, Gmsh,
//! Gaussian. Keeps the place for error messages: a line as long as the file is text up to there, else a byte.
class ValueCursor {
 public:
  //! \param file name for messages
  ValueCursor(std::string_view contents, std::string file);

  //! The next word, on whichever line; empty at the end of the file.
  std::string_view word();
  //! The same, without going there.
  std::string_view next_word() const;
  //! What is left of the line, without its end; the next one begins then.
  std::string_view line();
  bool at_end() const { return next_word().empty(); }

  //! \brief The next word as a finite number.
  //! \throw UserError (malformed)
  double real(const char* what);
  //! The same for one that is a coordinate: small enough that volumes are finite.
  double coordinate(const char* what);
  std::int64_t integer(const char* what);
  //! The next word as a whole number from 0 on.
  std::uint64_t count(const char* what);
  //! Bytes that follow where the cursor is.
  std::string_view bytes(std::size_t size, const char* what);

  //! Goes to a byte of the contents.
  void go_to(std::size_t offset) { at_ = offset; }

  std::size_t offset() const { return at_; }
  std::size_t remaining() const { return contents_.size() - at_; }
  const std::string& file() const { return file_; }

  //! \brief Fails at what was read last.
  //! \throw UserError (malformed)
  [[noreturn]] void fail(const std::string& what) const;
  [[noreturn]] void fail(const std::string& what, const std::string& remedy) const;

 private:
  std::string_view number_word(const char* what);  // fails where there is none

  std::string_view contents_;
  std::string file_;
  std::size_t at_ = 0;
  std::size_t last_ = 0;  // where what was read last began
  bool binary_ = false;   // whether bytes came before
};

}  // namespace nanocarbon::mesh
