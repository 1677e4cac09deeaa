#include "nanocarbon/mesh/mesh_format.h"

#include <cctype>
#include <string>

namespace nanocarbon {

std::optional<MeshFormat> format_of_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".off") return MeshFormat::off;
  if (extension == ".obj") return MeshFormat::obj;
  if (extension == ".ply") return MeshFormat::ply;
  if (extension == ".stl") return MeshFormat::stl;
  return std::nullopt;
}

}  // namespace nanocarbon
