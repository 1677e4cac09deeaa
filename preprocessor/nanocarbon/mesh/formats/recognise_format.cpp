// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/recognise_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/formats/read_off.h"
#include "nanocarbon/mesh/formats/read_stl.h"
#include "nanocarbon/mesh/grids/read_cube.h"
#include "nanocarbon/mesh/grids/read_mrc.h"
#include "nanocarbon/mesh/grids/read_msh.h"
#include "nanocarbon/mesh/grids/read_vtk.h"
#include "nanocarbon/mesh/grids/read_vtk_xml.h"
#include "nanocarbon/mesh/parsing/text_scanner.h"
#include "nanocarbon/mesh/scenes/read_3mf.h"
#include "nanocarbon/mesh/scenes/read_gltf.h"

namespace nanocarbon::mesh {
namespace {

bool begins_like_obj(std::string_view line) {
  constexpr std::array keywords = {"v", "vt", "vn", "f", "g", "o", "s", "mtllib", "usemtl"};
  const std::string_view word = line.substr(0, line.find_first_of(" \t\r"));
  return std::find(keywords.begin(), keywords.end(), word) != keywords.end();
}

[[noreturn]] void fail_unknown(std::string_view contents, const std::string& file) {
  const char* what = "is in none of the formats that are read";
  if (contents.empty()) what = "is empty";
  if (contents.starts_with("PK")) what = "is a ZIP archive, but no 3MF file (unpack it first)";
  throw UserError(
      Failure::malformed,
      fmt::format("{}: the file {}; give a mesh as OFF, OBJ, PLY, STL, glTF, 3MF, VTK or MSH, or a field "
                  "as cube, MRC or VTI",
                  file, what));
}

}  // namespace

MeshFormat recognised_format(std::string_view contents, const std::string& file) {
  if (contents.starts_with("ply\n") || contents.starts_with("ply\r") || contents.starts_with("ply "))
    return MeshFormat::ply;
  if (begins_like_gltf(contents)) return MeshFormat::gltf;
  if (begins_like_vtk(contents)) return MeshFormat::vtk;
  if (begins_like_vtk_xml(contents)) return MeshFormat::vtk_xml;
  if (begins_like_msh(contents)) return MeshFormat::msh;
  if (begins_like_3mf(contents)) return MeshFormat::three_mf;
  if (is_text_stl(contents) || has_binary_stl_size(contents)) return MeshFormat::stl;
  if (begins_like_mrc(contents)) return MeshFormat::mrc;
  if (begins_like_cube(contents)) return MeshFormat::cube;
  TextScanner scanner(contents, file, {});
  scanner.next_line();
  if (begins_like_off(scanner.rest())) return MeshFormat::off;
  if (begins_like_obj(scanner.rest())) return MeshFormat::obj;
  const std::optional<MeshFormat> hint = format_of_extension(file);
  if (contents.empty() || !hint || contents.starts_with("PK")) fail_unknown(contents, file);
  return *hint;
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

}  // namespace nanocarbon::mesh
