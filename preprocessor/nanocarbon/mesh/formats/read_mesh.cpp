// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/read_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/formats/cell_comment.h"
#include "nanocarbon/mesh/formats/mesh_format.h"
#include "nanocarbon/mesh/formats/read_obj.h"
#include "nanocarbon/mesh/formats/read_off.h"
#include "nanocarbon/mesh/formats/read_ply.h"
#include "nanocarbon/mesh/formats/read_stl.h"
#include "nanocarbon/mesh/formats/recognise_format.h"
#include "nanocarbon/mesh/grids/isosurface.h"
#include "nanocarbon/mesh/grids/read_cube.h"
#include "nanocarbon/mesh/grids/read_mrc.h"
#include "nanocarbon/mesh/grids/read_msh.h"
#include "nanocarbon/mesh/grids/read_vtk.h"
#include "nanocarbon/mesh/grids/read_vtk_xml.h"
#include "nanocarbon/mesh/parsing/inflate.h"
#include "nanocarbon/mesh/scenes/read_3mf.h"
#include "nanocarbon/mesh/scenes/read_gltf.h"

namespace nanocarbon::mesh {
namespace {

constexpr std::uintmax_t largest_file = std::uintmax_t{4} << 30;

[[noreturn]] void fail_to_read(const std::filesystem::path& path, const std::string& reason) {
  throw UserError(Failure::unreadable, fmt::format("{}: cannot be read: {}", path.string(), reason));
}

// The bytes of a file or pipe.
std::string file_contents(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) fail_to_read(path, error ? error.message() : "there is no such file");
  if (std::filesystem::is_directory(status)) fail_to_read(path, "it is a directory; name a mesh file in it");
  const bool pipe = std::filesystem::is_fifo(status);
  if (!std::filesystem::is_regular_file(status) && !pipe) fail_to_read(path, "it is not a regular file");

  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail_to_read(path, errno ? std::strerror(errno) : "it cannot be opened");
  std::string contents;
  if (!pipe) {
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error) fail_to_read(path, error.message());
    if (size > largest_file) fail_to_read(path, "it is larger than 4 GiB");
    contents.reserve(size + 1);
  }
  std::array<char, 65536> block;
  while (stream.read(block.data(), block.size()) || stream.gcount() > 0) {
    contents.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    if (contents.size() > largest_file) fail_to_read(path, "it is larger than 4 GiB");
  }
  if (stream.bad()) fail_to_read(path, errno ? std::strerror(errno) : "read error");
  return contents;
}

bool holds_cell_comments(MeshFormat format) {
  return format == MeshFormat::off || format == MeshFormat::obj || format == MeshFormat::ply;
}

// A file of VTK holds one or the other.
PolygonSoup surface_of(const GridContents& contents, const FieldRequest& field, const std::string& file) {
  if (const auto* soup = std::get_if<PolygonSoup>(&contents)) return *soup;
  return isosurface(std::get<ScalarField>(contents), field, file);
}

// What a download may leave in place of the file.
void require_the_file_itself(std::string_view contents, const std::string& file) {
  const char* what = nullptr;
  if (contents.starts_with("version https://git-lfs"))
    what = "is a pointer of Git LFS in place of the mesh; fetch the mesh with git lfs pull";
  std::string beginning(contents.substr(0, 64));
  for (char& c : beginning) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::size_t first = std::min(beginning.find_first_not_of(" \t\r\n"), beginning.size());
  if (beginning.compare(first, 9, "<!doctype") == 0 || beginning.compare(first, 5, "<html") == 0)
    what = "is a web page in place of the mesh; download the mesh itself";
  if (what != nullptr) throw UserError(Failure::malformed, fmt::format("{}: the file {}", file, what));
}

PolygonSoup parse_faces(MeshFormat format, std::string_view contents, const std::string& file,
                        const FieldRequest& field) {
  switch (format) {
    case MeshFormat::off:
      return read_off(contents, file);
    case MeshFormat::obj:
      return read_obj(contents, file);
    case MeshFormat::ply:
      return read_ply(contents, file);
    case MeshFormat::gltf:
      return read_gltf(contents, file);
    case MeshFormat::three_mf:
      return read_3mf(contents, file);
    case MeshFormat::vtk:
      return surface_of(read_vtk(contents, file, field.array), field, file);
    case MeshFormat::vtk_xml:
      return surface_of(read_vtk_xml(contents, file, field.array), field, file);
    case MeshFormat::msh:
      return read_msh(contents, file);
    case MeshFormat::cube:
      return isosurface(read_cube(contents, file, field.array), field, file);
    case MeshFormat::mrc:
      return isosurface(read_mrc(contents, file), field, file);
    case MeshFormat::stl:
      break;
  }
  return read_stl(contents, file);
}

PolygonSoup parse_unpacked(std::string_view contents, const std::string& file, const FieldRequest& field) {
  if (contents.starts_with("\xEF\xBB\xBF")) contents.remove_prefix(3);
  if (is_utf16(contents) && !has_binary_stl_size(contents))
    throw UserError(Failure::malformed,
                    fmt::format("{}: the file is text in UTF-16; save it as UTF-8 or ASCII", file));
  require_the_file_itself(contents, file);
  const MeshFormat format = recognised_format(contents, file);
  PolygonSoup soup = parse_faces(format, contents, file, field);
  if (field.level && !soup.is_isosurface)
    throw UserError(Failure::usage,
                    fmt::format("{}: the file holds a mesh, not a scalar field: leave out --level", file));
  if (holds_cell_comments(format)) soup.cell = cell_in_comment(contents, file);
  return soup;
}

}  // namespace

PolygonSoup parse_mesh(std::string_view contents, const std::string& file, const FieldRequest& field) {
  if (!contents.starts_with("\x1f\x8b")) return parse_unpacked(contents, file, field);
  const std::optional<std::string> unpacked = inflated(contents, Packing::gzip, largest_file);
  if (!unpacked)
    throw UserError(
        Failure::malformed,
        fmt::format("{}: the file is compressed with gzip, and damaged, cut short, or above 4 GiB unpacked; "
                    "pack it again",
                    file));
  return parse_unpacked(*unpacked, file, field);
}

PolygonSoup read_mesh(const std::filesystem::path& path, const FieldRequest& field) {
  return parse_mesh(file_contents(path), path.string(), field);
}

}  // namespace nanocarbon::mesh
