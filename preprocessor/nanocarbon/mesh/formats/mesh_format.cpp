// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/mesh_format.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <string>
#include <string_view>
#include <utility>

#include "nanocarbon/core/error.h"

namespace nanocarbon::mesh {
namespace {

constexpr std::array<std::pair<std::string_view, MeshFormat>, 17> extensions = {
    {{".off", MeshFormat::off},
     {".obj", MeshFormat::obj},
     {".ply", MeshFormat::ply},
     {".stl", MeshFormat::stl},
     {".gltf", MeshFormat::gltf},
     {".glb", MeshFormat::gltf},
     {".3mf", MeshFormat::three_mf},
     {".vtk", MeshFormat::vtk},
     {".vtp", MeshFormat::vtk_xml},
     {".vtu", MeshFormat::vtk_xml},
     {".vti", MeshFormat::vtk_xml},
     {".msh", MeshFormat::msh},
     {".cube", MeshFormat::cube},
     {".cub", MeshFormat::cube},
     {".mrc", MeshFormat::mrc},
     {".map", MeshFormat::mrc},
     {".ccp4", MeshFormat::mrc}}};

}  // namespace

std::optional<MeshFormat> format_of_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".gz") return format_of_extension(path.stem());
  for (const auto& [name, format] : extensions)
    if (extension == name) return format;
  return std::nullopt;
}

MeshFormat format_to_write(const std::filesystem::path& path) {
  const std::optional<MeshFormat> format = format_of_extension(path);
  if (!format || *format > MeshFormat::stl || path.extension() == ".gz")
    throw UserError(Failure::usage, fmt::format("{}: the extension is not that of a format that meshes are "
                                                "written to; use .off, .obj, .ply or .stl",
                                                path.string()));
  return *format;
}

}  // namespace nanocarbon::mesh
