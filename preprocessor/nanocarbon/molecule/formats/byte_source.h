// SPDX-License-Identifier: GPL-2.0-or-later
// Where the bytes of a file come from: a path, standard input, or memory; gzip is unpacked on the way.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string_view>

namespace nanocarbon::molecule {

//! Writes the next bytes to an address, at most as many as said, and returns how many there were; 0 at the end.
using ByteSource = std::function<std::size_t(char* to, std::size_t most)>;

//! \brief The bytes of a file, or of standard input where the path is `-`.
//! \details What begins as gzip does is unpacked, whatever the name; bytes come as they are asked for, so that
//! files of any size can be read.
//! \throw UserError (unreadable) naming the path and the system's reason, at once or by the source
//! \throw UserError (malformed) by the source, where packed bytes are damaged or end early
ByteSource open_bytes(const std::filesystem::path& path);

//! \pre the bytes stay where they are as long as the source is used
ByteSource bytes_of(std::string_view contents);

//! How messages call a path: the path, or "standard input".
std::string shown_name(const std::filesystem::path& path);

}  // namespace nanocarbon::molecule
