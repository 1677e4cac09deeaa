// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers in the text of files and how messages quote such text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace nanocarbon {

//! What a token is when read as a number.
enum class NumberToken { number, not_a_number, too_large };

//! \brief A real number and nothing else: exact, whatever the locale; may have a plus sign.
//! \details Numbers too small for a double are zero. Infinities and NaN are numbers.
NumberToken read_real(std::string_view token, double& value);
//! A whole number and nothing else; may have a plus sign.
NumberToken read_integer(std::string_view token, std::int64_t& value);

//! Text as a message shows it: shortened, with bytes replaced that would upset a terminal.
std::string shown(std::string_view text, std::size_t most = 60);

}  // namespace nanocarbon
