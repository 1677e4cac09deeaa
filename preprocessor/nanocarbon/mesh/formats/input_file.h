// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace nanocarbon::mesh {

//! \brief The bytes of a file.
//! \throw UserError (unreadable) for a file that is missing, a directory or device, not allowed to be opened,
//! or larger than 4 GiB
std::string file_contents(const std::filesystem::path& path);

}  // namespace nanocarbon::mesh
