// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/mesh_format.h"

#include <fmt/format.h>

#include <cctype>
#include <string>

#include "nanocarbon/core/error.h"

namespace nanocarbon::mesh {

std::optional<MeshFormat> format_of_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".off") return MeshFormat::off;
  if (extension == ".obj") return MeshFormat::obj;
  if (extension == ".ply") return MeshFormat::ply;
  if (extension == ".stl") return MeshFormat::stl;
  return std::nullopt;
}

MeshFormat format_to_write(const std::filesystem::path& path) {
  const std::optional<MeshFormat> format = format_of_extension(path);
  if (!format)
    throw UserError(
        Failure::usage,
        fmt::format("{}: the extension is not that of a mesh format; use .off, .obj, .ply or .stl",
                    path.string()));
  return *format;
}

}  // namespace nanocarbon::mesh
