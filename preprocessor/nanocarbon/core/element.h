// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace nanocarbon {

//! The elements REBO2 is defined for. The values index parameter tables.
enum class Element : std::uint8_t { carbon = 0, hydrogen = 1 };

//! Chemical symbol, "C" or "H".
std::string_view symbol(Element element);

//! Standard atomic mass, g/mol, as LAMMPS's examples use them (C 12.011, H 1.008).
double mass(Element element);

//! The element of a chemical symbol, or nothing for any other text.
std::optional<Element> element_from_symbol(std::string_view symbol);

}  // namespace nanocarbon
