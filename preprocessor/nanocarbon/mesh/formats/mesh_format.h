// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <optional>

namespace nanocarbon::mesh {

//! The formats that a mesh is read from. It is written to the first four.
enum class MeshFormat { off, obj, ply, stl, gltf, three_mf, vtk, vtk_xml, msh, cube, mrc };

//! The format that a path's extension names, in upper or lower case, that of a packed file without its ".gz"; or
//! nothing.
std::optional<MeshFormat> format_of_extension(const std::filesystem::path& path);

//! The same for a file that is to be written.
//! \throw UserError (usage) where the extension names none that is written
MeshFormat format_to_write(const std::filesystem::path& path);

}  // namespace nanocarbon::mesh
