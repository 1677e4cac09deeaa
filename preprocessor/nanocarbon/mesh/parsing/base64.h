// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace nanocarbon::mesh {

//! \brief Bytes that were written as text in base64 (RFC 4648); blanks and line ends are passed over.
//! \details Several encodings one after the other, each padded by itself, are one, as VTK writes them.
//! \return nothing where a character does not belong there
std::optional<std::string> from_base64(std::string_view text);

//! Characters of base64 that hold so many bytes, padding included.
constexpr std::size_t base64_length(std::size_t bytes) { return (bytes + 2) / 3 * 4; }

}  // namespace nanocarbon::mesh
