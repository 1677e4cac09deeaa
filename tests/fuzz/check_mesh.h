// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace nanocarbon::test {

enum class Depth { reading, repair };

//! \brief Reads a mesh as a user's file would be, whatever the bytes, and repairs it if that is asked for.
//! \return "" where it was refused as the user's error or came out as promised; else what promise was broken.
//! Anything but a UserError passes through.
std::string broken_promise(std::string_view contents, const std::string& file, Depth depth = Depth::repair);

}  // namespace nanocarbon::test
