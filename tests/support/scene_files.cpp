// SPDX-License-Identifier: GPL-2.0-or-later
#include "support/scene_files.h"

#include <fmt/format.h>

#include <cstdint>

#include "nanocarbon/mesh/parsing/byte_order.h"
#include "nanocarbon/mesh/parsing/inflate.h"

namespace nanocarbon::test {
namespace {

template <typename Number>
void put(std::string& to, Number number) {
  const auto bytes = mesh::bytes_of(number, mesh::ByteOrder::little);
  to.append(bytes.data(), bytes.size());
}

}  // namespace

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 3; ++i)
      bits = bits << 8 | (i < count ? static_cast<unsigned char>(bytes[at + i]) : 0u);
    for (std::size_t i = 0; i < 4; ++i) result += i <= count ? digits[bits >> (18 - 6 * i) & 63] : '=';
  }
  return result;
}

std::string stored_zip(const std::vector<std::pair<std::string, std::string>>& files) {
  std::string archive, directory;
  for (const auto& [name, contents] : files) {
    std::string common;  // of both headers: version, flags, method, time, date, check sum, sizes, lengths
    for (const int field : {20, 0, 0, 0, 0x21}) put(common, static_cast<std::uint16_t>(field));
    put(common, mesh::crc32_of(contents));
    put(common, static_cast<std::uint32_t>(contents.size()));
    put(common, static_cast<std::uint32_t>(contents.size()));
    put(common, static_cast<std::uint16_t>(name.size()));
    put(common, std::uint16_t{0});
    directory += "PK\x01\x02";
    put(directory, std::uint16_t{20});
    directory += common + std::string(10, '\0');  // comment, disk, attributes
    put(directory, static_cast<std::uint32_t>(archive.size()));
    directory += name;
    archive += "PK\x03\x04" + common + name + contents;
  }
  const std::size_t begin = archive.size();
  archive += directory + "PK\x05\x06" + std::string(4, '\0');
  for (int i = 0; i < 2; ++i) put(archive, static_cast<std::uint16_t>(files.size()));
  put(archive, static_cast<std::uint32_t>(directory.size()));
  put(archive, static_cast<std::uint32_t>(begin));
  return archive + std::string(2, '\0');
}

std::string gltf_buffer(const TriangleMesh& mesh) {
  std::string buffer;
  for (const Vec3& point : mesh.points)
    for (const double x : point) put(buffer, static_cast<float>(x));
  for (const Triangle& triangle : mesh.triangles)
    for (const VertexIndex v : triangle) put(buffer, std::uint32_t{v});
  return buffer;
}

std::string gltf_json(const TriangleMesh& mesh, const std::string& uri, const std::string& scene) {
  const std::size_t points = 12 * mesh.points.size(), indices = 12 * mesh.triangles.size();
  return fmt::format(
      R"({{"asset": {{"version": "2.0"}}, {}, "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "indices": 1}}]}}],
"accessors": [{{"bufferView": 0, "componentType": 5126, "count": {}, "type": "VEC3"}},
 {{"bufferView": 1, "componentType": 5125, "count": {}, "type": "SCALAR"}}],
"bufferViews": [{{"buffer": 0, "byteLength": {}}}, {{"buffer": 0, "byteOffset": {}, "byteLength": {}}}],
"buffers": [{{{}"byteLength": {}}}]}})",
      scene, mesh.points.size(), 3 * mesh.triangles.size(), points, points, indices,
      uri.empty() ? "" : "\"uri\": " + uri + ", ", points + indices);
}

std::string glb(const std::string& json, const std::string& buffer) {
  const std::string text = json + std::string((4 - json.size() % 4) % 4, ' ');
  std::string file = "glTF";
  put(file, std::uint32_t{2});
  put(file, static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + buffer.size()));
  put(file, static_cast<std::uint32_t>(text.size()));
  file += "JSON" + text;
  put(file, static_cast<std::uint32_t>(buffer.size()));
  return file + std::string("BIN\0", 4) + buffer;
}

std::string glb(const TriangleMesh& mesh) { return glb(gltf_json(mesh, ""), gltf_buffer(mesh)); }

std::string mesh_3mf(const TriangleMesh& mesh) {
  std::string text = "<mesh><vertices>\n";
  for (const Vec3& p : mesh.points)
    text += fmt::format("<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n", p.x(), p.y(), p.z());
  text += "</vertices><triangles>\n";
  for (const auto& [a, b, c] : mesh.triangles)
    text += fmt::format("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n", a, b, c);
  return text + "</triangles></mesh>";
}

std::string file_3mf(const std::string& resources, const std::string& build, const std::string& unit) {
  const std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  return stored_zip(
      {{"[Content_Types].xml",
        xml + "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\"><Default "
              "Extension=\"rels\" "
              "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/><Default "
              "Extension=\"model\" "
              "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>"},
       {"_rels/.rels",
        xml + "<Relationships "
              "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
              "Target=\"/3D/part.model\" Id=\"r\" "
              "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
       {"3D/part.model",
        xml + "<model unit=\"" + unit +
            "\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
            "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\">\n<resources>\n" +
            resources + "\n</resources>\n<build>\n" + build + "\n</build>\n</model>\n"}});
}

std::string file_3mf(const TriangleMesh& mesh) {
  return file_3mf("<object id=\"1\">" + mesh_3mf(mesh) + "</object>", "<item objectid=\"1\"/>");
}

}  // namespace nanocarbon::test
