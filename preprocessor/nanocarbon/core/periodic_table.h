// SPDX-License-Identifier: GPL-2.0-or-later
// The elements by number, so that a file with others than carbon and hydrogen is refused by their names.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace nanocarbon {

using AtomicNumber = std::uint8_t;  //!< 1 to 118

std::string_view element_symbol(AtomicNumber z);  //!< "Au"
std::string_view element_name(AtomicNumber z);    //!< "gold"

//! Symbols in their own case: "CO" is none.
std::optional<AtomicNumber> atomic_number_of_symbol(std::string_view symbol);
//! Names in lower case.
std::optional<AtomicNumber> atomic_number_of_name(std::string_view name);
//! The element whose mass is nearest and within 0.1 g/mol, or hydrogen for deuterium's 2.014.
std::optional<AtomicNumber> atomic_number_of_mass(double mass);

}  // namespace nanocarbon
