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
#include "nanocarbon/mesh/parsing/text_scanner.h"

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

bool begins_like_obj(std::string_view line) {
  constexpr std::array keywords = {"v", "vt", "vn", "f", "g", "o", "s", "mtllib", "usemtl"};
  const std::string_view word = line.substr(0, line.find_first_of(" \t\r"));
  return std::find(keywords.begin(), keywords.end(), word) != keywords.end();
}

bool is_utf16(std::string_view contents) {
  if (contents.starts_with("\xFF\xFE") || contents.starts_with("\xFE\xFF")) return true;
  if (contents.size() < 8) return false;
  const auto is_text = [](char c) { return (c >= 32 && c < 127) || c == '\n' || c == '\r' || c == '\t'; };
  for (const std::size_t first : {std::size_t{0}, std::size_t{1}}) {
    bool all = true;
    for (std::size_t i = 0; i < 8; i += 2)
      all = all && is_text(contents[i + first]) && contents[i + 1 - first] == '\0';
    if (all) return true;
  }
  return false;
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

[[noreturn]] void fail_unknown(std::string_view contents, const std::string& file) {
  const char* what = "is not an OFF, OBJ, PLY or STL file";
  if (contents.empty()) what = "is empty";
  if (contents.starts_with("\x1f\x8b")) what = "is compressed with gzip (decompress it first)";
  if (contents.starts_with("PK")) what = "is a ZIP archive such as 3MF (unpack or convert it first)";
  throw UserError(Failure::malformed,
                  fmt::format("{}: the file {}; give a mesh in one of the formats OFF, OBJ, PLY "
                              "and STL",
                              file, what));
}

MeshFormat format_of(std::string_view contents, const std::string& file) {
  if (contents.starts_with("ply\n") || contents.starts_with("ply\r") || contents.starts_with("ply "))
    return MeshFormat::ply;
  if (is_text_stl(contents) || has_binary_stl_size(contents)) return MeshFormat::stl;
  TextScanner scanner(contents, file, {});
  scanner.next_line();
  if (begins_like_off(scanner.rest())) return MeshFormat::off;
  if (begins_like_obj(scanner.rest())) return MeshFormat::obj;
  const std::optional<MeshFormat> hint = format_of_extension(file);
  if (contents.empty() || !hint || contents.starts_with("\x1f\x8b") || contents.starts_with("PK"))
    fail_unknown(contents, file);
  return *hint;
}

PolygonSoup parse_faces(std::string_view contents, const std::string& file) {
  switch (format_of(contents, file)) {
    case MeshFormat::off:
      return read_off(contents, file);
    case MeshFormat::obj:
      return read_obj(contents, file);
    case MeshFormat::ply:
      return read_ply(contents, file);
    case MeshFormat::stl:
      break;
  }
  return read_stl(contents, file);
}

}  // namespace

PolygonSoup parse_mesh(std::string_view contents, const std::string& file) {
  if (contents.starts_with("\xEF\xBB\xBF")) contents.remove_prefix(3);
  if (is_utf16(contents) && !has_binary_stl_size(contents))
    throw UserError(Failure::malformed,
                    fmt::format("{}: the file is text in UTF-16; save it as UTF-8 or ASCII", file));
  require_the_file_itself(contents, file);
  PolygonSoup soup = parse_faces(contents, file);
  soup.cell = cell_in_comment(contents, file);
  return soup;
}

PolygonSoup read_mesh(const std::filesystem::path& path) {
  return parse_mesh(file_contents(path), path.string());
}

}  // namespace nanocarbon::mesh
