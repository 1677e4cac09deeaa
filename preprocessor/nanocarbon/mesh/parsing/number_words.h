// SPDX-License-Identifier: GPL-2.0-or-later
// Words of a file as numbers, wherever a reader found them, and how messages show them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace nanocarbon::mesh {

//! A number, or what is wrong with the word: the part of a message after the place.
struct NumberWord {
  std::int64_t value = 0;
  std::string fault;  //!< empty where it is a number
};

//! \param what names the number in the message
NumberWord integer_word(std::string_view word, const char* what);
//! The same for a whole number from 0 on.
NumberWord count_word(std::string_view word, const char* what);

//! \brief A coordinate that has been read as text or binary: finite, and small enough that areas and
//! volumes are finite.
//! \return what is wrong with it, or nullptr
const char* coordinate_fault(double value);

//! Text for a message: shortened, with unprintable bytes replaced.
std::string quoted(std::string_view text);

}  // namespace nanocarbon::mesh
