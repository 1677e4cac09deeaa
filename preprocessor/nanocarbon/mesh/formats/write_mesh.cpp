// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/write_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <ostream>
#include <utility>

#include "nanocarbon/core/error.h"
#include "nanocarbon/core/output_file.h"
#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/formats/cell_comment.h"
#include "nanocarbon/mesh/formats/mesh_format.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/parsing/byte_order.h"
#include "nanocarbon/mesh/periodic_mesh.h"

namespace nanocarbon::mesh {
namespace {

// Collects text and hands it to the stream in large blocks. Doubles are formatted with "{}": the fewest
// digits that read back to the same number.
class Text {
 public:
  explicit Text(std::ostream& out) : out_(out) {}
  Text(const Text&) = delete;
  Text& operator=(const Text&) = delete;

  template <typename... Values>
  void put(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Values>(values)...);
    if (buffer_.size() > 60000) flush();
  }
  template <typename Number>
  void put_bytes(Number number) {
    const auto bytes = bytes_of(number, ByteOrder::little);
    buffer_.append(bytes.data(), bytes.data() + bytes.size());
    if (buffer_.size() > 60000) flush();
  }
  void flush() {
    out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
  }

 private:
  std::ostream& out_;
  fmt::memory_buffer buffer_;
};

bool has_vertex_colours(const MeshColours* colours, const TriangleMesh& mesh) {
  return colours && !mesh.points.empty() && colours->vertices.size() == mesh.points.size();
}

void put_off(Text& text, const TriangleMesh& mesh, const MeshColours* colours, const std::string& cell) {
  const bool coloured = has_vertex_colours(colours, mesh);
  text.put("{}OFF\n{} {} 0\n", coloured ? "C" : "", mesh.points.size(), mesh.triangles.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Vec3& p = mesh.points[v];
    text.put("{} {} {}", p.x(), p.y(), p.z());
    if (coloured)
      text.put(" {} {} {} 255", colours->vertices[v][0], colours->vertices[v][1], colours->vertices[v][2]);
    text.put("\n");
  }
  for (const auto& [a, b, c] : mesh.triangles) text.put("3 {} {} {}\n", a, b, c);
  if (!cell.empty()) text.put("# {}\n", cell);
}

void put_obj(Text& text, const TriangleMesh& mesh, const std::string& cell) {
  if (!cell.empty()) text.put("# {}\n", cell);
  for (const Vec3& p : mesh.points) text.put("v {} {} {}\n", p.x(), p.y(), p.z());
  for (const auto& [a, b, c] : mesh.triangles)
    text.put("f {} {} {}\n", std::uint64_t{a} + 1, std::uint64_t{b} + 1, std::uint64_t{c} + 1);
}

void put_ply_header(Text& text, const TriangleMesh& mesh, const MeshFileOptions& options, bool coloured,
                    const std::string& cell) {
  constexpr const char* colour = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  text.put("ply\nformat {} 1.0\n", options.text ? "ascii" : "binary_little_endian");
  if (!cell.empty()) text.put("comment {}\n", cell);
  text.put("element vertex {}\nproperty double x\nproperty double y\nproperty double z\n",
           mesh.points.size());
  if (coloured) text.put("{}", colour);
  text.put("element face {}\nproperty list uchar int vertex_indices\n", mesh.triangles.size());
  if (options.colours && !options.colours->edges.empty())
    text.put("element edge {}\nproperty int vertex1\nproperty int vertex2\n{}", options.colours->edges.size(),
             colour);
  text.put("end_header\n");
}

void put_ply(Text& text, const TriangleMesh& mesh, const MeshFileOptions& options, const std::string& cell) {
  const bool coloured = has_vertex_colours(options.colours, mesh);
  put_ply_header(text, mesh, options, coloured, cell);
  const auto put = [&](auto number) {
    if (options.text)
      text.put("{} ", number);
    else
      text.put_bytes(number);
  };
  const auto put_colour = [&](const Rgb& colour) {
    for (const std::uint8_t channel : colour) put(channel);
  };
  const auto end = [&] {
    if (options.text) text.put("\n");
  };
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    for (const double x : mesh.points[v]) put(x);
    if (coloured) put_colour(options.colours->vertices[v]);
    end();
  }
  for (const Triangle& triangle : mesh.triangles) {
    put(std::uint8_t{3});
    for (const VertexIndex v : triangle) put(static_cast<std::int32_t>(v));
    end();
  }
  if (!options.colours) return;
  for (const ColouredEdge& edge : options.colours->edges) {
    put(static_cast<std::int32_t>(edge.a));
    put(static_cast<std::int32_t>(edge.b));
    put_colour(edge.colour);
    end();
  }
}

void put_stl(Text& text, const TriangleMesh& mesh, bool as_text) {
  if (as_text) {
    text.put("solid nanocarbon\n");
  } else {
    for (int i = 0; i < 10; ++i)
      text.put_bytes(std::uint64_t{0});  // a free-form header, better not one with "solid"
    text.put_bytes(static_cast<std::uint32_t>(mesh.triangles.size()));
  }
  for (const Triangle& triangle : mesh.triangles) {
    const Vec3 normal =
        area_normal(mesh.points[triangle[0]], mesh.points[triangle[1]], mesh.points[triangle[2]])
            .normalized();
    if (as_text) {
      text.put("facet normal {} {} {}\n outer loop\n", normal.x(), normal.y(), normal.z());
      for (const VertexIndex v : triangle)
        text.put("  vertex {} {} {}\n", mesh.points[v].x(), mesh.points[v].y(), mesh.points[v].z());
      text.put(" endloop\nendfacet\n");
    } else {
      for (const double x : normal) text.put_bytes(static_cast<float>(x));
      for (const VertexIndex v : triangle)
        for (const double x : mesh.points[v]) text.put_bytes(static_cast<float>(x));
      text.put_bytes(std::uint16_t{0});
    }
  }
  if (as_text) text.put("endsolid nanocarbon\n");
}

void put_mesh(std::ostream& out, MeshFormat format, const TriangleMesh& mesh, const MeshFileOptions& options,
              const std::string& cell) {
  Text text(out);
  switch (format) {
    case MeshFormat::off:
      put_off(text, mesh, options.colours, cell);
      break;
    case MeshFormat::obj:
      put_obj(text, mesh, cell);
      break;
    case MeshFormat::ply:
      put_ply(text, mesh, options, cell);
      break;
    case MeshFormat::stl:
      put_stl(text, mesh, options.text);
      break;
    default:
      throw UserError(Failure::usage, "meshes are written as OFF, OBJ, PLY and STL alone");
  }
  text.flush();
}

// Colours of a mesh in a cell for what it is cut open to.
MeshColours unfolded_colours(const MeshColours& colours, const Unfolded& open) {
  MeshColours result;
  if (!colours.vertices.empty())
    for (const VertexIndex v : open.source) result.vertices.push_back(colours.vertices[v]);
  std::map<std::pair<VertexIndex, VertexIndex>, Rgb> of_edge;
  for (const ColouredEdge& edge : colours.edges) of_edge[std::minmax(edge.a, edge.b)] = edge.colour;
  const EdgeTable edges = edge_table(soup_of(open.mesh));
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto colour = of_edge.find(std::minmax(open.source[edges.low[e]], open.source[edges.high[e]]));
    if (colour != of_edge.end()) result.edges.push_back({edges.low[e], edges.high[e], colour->second});
  }
  return result;
}

}  // namespace

void write_mesh(std::ostream& out, MeshFormat format, const TriangleMesh& mesh,
                const MeshFileOptions& options) {
  std::string cell;
  if (mesh.space.periodic()) {
    if (format == MeshFormat::stl)
      throw UserError(Failure::usage, "an STL file cannot hold a periodic cell; write OFF, OBJ or PLY");
    cell = cell_comment(*mesh.space.cell());
    const Unfolded open = unfolded(mesh);
    MeshFileOptions open_options = options;
    MeshColours colours;
    if (options.colours) {
      colours = unfolded_colours(*options.colours, open);
      open_options.colours = &colours;
    }
    put_mesh(out, format, open.mesh, open_options, cell);
    return;
  }
  put_mesh(out, format, mesh, options, cell);
}

void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh, const MeshFileOptions& options) {
  const MeshFormat format = format_to_write(path);
  write_file(path, [&](std::ostream& out) { write_mesh(out, format, mesh, options); });
}

}  // namespace nanocarbon::mesh
