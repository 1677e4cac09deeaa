// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <optional>

namespace nanocarbon::mesh {

//! The formats a mesh is read from and written to.
enum class MeshFormat { off, obj, ply, stl };

//! The format that a path's extension names, in upper or lower case, or nothing.
std::optional<MeshFormat> format_of_extension(const std::filesystem::path& path);

//! The same for a file that is to be written.
//! \throw UserError (usage) where the extension names none
MeshFormat format_to_write(const std::filesystem::path& path);

}  // namespace nanocarbon::mesh
