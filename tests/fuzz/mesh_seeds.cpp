// SPDX-License-Identifier: GPL-2.0-or-later
#include "fuzz/seeds.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "nanocarbon/mesh/formats/mesh_colours.h"
#include "nanocarbon/mesh/formats/write_mesh.h"
#include "nanocarbon/mesh/parsing/byte_order.h"
#include "nanocarbon/mesh/triangulate.h"
#include "support/grid_files.h"
#include "support/scene_files.h"
#include "support/small_meshes.h"

namespace nanocarbon::test {
namespace {

std::string contents_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string binary_off(const TriangleMesh& mesh) {
  std::string bytes = "OFF BINARY\n";
  const auto add = [&](auto value) {
    for (const char byte : mesh::bytes_of(value, mesh::ByteOrder::big)) bytes += byte;
  };
  for (const std::size_t count : {mesh.points.size(), mesh.triangles.size(), std::size_t{0}})
    add(static_cast<std::uint32_t>(count));
  for (const Vec3& p : mesh.points)
    for (int d = 0; d < 3; ++d) add(static_cast<float>(p[d]));
  for (const auto& [a, b, c] : mesh.triangles)
    for (const std::uint32_t number : {3u, a, b, c, 0u}) add(number);
  return bytes;
}

void add_scenes_and_grids(std::vector<Seed>& seeds) {
  const TriangleMesh mesh = tetrahedron();
  seeds.push_back({"a.glb", glb(mesh)});
  seeds.push_back({"a.gltf", gltf_json(mesh, "\"data:;base64," + base64(gltf_buffer(mesh)) + "\"",
                                       R"("scene": 0, "scenes": [{"nodes": [1]}], "nodes": [
    {"mesh": 0, "rotation": [0, 0, 0.6, 0.8], "scale": [1, -2, 1]}, {"children": [0], "translation": [1, 2, 3]}])")});
  seeds.push_back({"a.3mf", file_3mf(mesh)});
  seeds.push_back({"b.3mf", file_3mf("<object id=\"1\">" + mesh_3mf(mesh) +
                                         "</object><object id=\"2\"><components><component objectid=\"1\" "
                                         "transform=\"1 0 0 0 1 0 0 0 1 9 0 0\"/></components></object>",
                                     "<item objectid=\"2\"/><item objectid=\"1\"/>", "inch")});
  seeds.push_back({"a.vtk", vtk_text(mesh)});
  seeds.push_back({"a.vtp", vtp_text(mesh)});
  seeds.push_back({"a.msh", msh_text(mesh)});
  const SampledField field = {{4, 3, 5}, Vec3(-1, 0, 2), 0.5 * Mat3::Identity(), [](const Vec3& x) {
                                return x.x() + x.y() * x.z() - 2;
                              }};
  seeds.push_back({"a.cube", cube_text(field)});
  seeds.push_back({"a.mrc", mrc_bytes(field)});
  seeds.push_back({"b.mrc", mrc_bytes(field, true, {2, 3, 1})});
  seeds.push_back({"a.vti", vti_text(field)});
  seeds.push_back({"b.vtk", structured_points_text(field)});
  // What other programs wrote: packed, in base64, raw, in blocks, of either byte order.
  const auto folder = std::filesystem::path(__FILE__).parent_path().parent_path() / "mesh/grids/files";
  for (const char* name :
       {"octahedron_a.msh", "octahedron_c.msh", "octahedron_a.vtk", "octahedron_a.vtu", "octahedron_c.vtu",
        "octahedron_vtk_raw_blocks.vtp", "octahedron_vtk_raw_unpacked_big.vtp", "octahedron_vtk_base64.vtp",
        "octahedron_vtk_42.vtk", "octahedron_vtk_strips.vtk", "hex_a.vtu", "tet_22.msh"})
    seeds.push_back({name, contents_of(folder / name)});
}

}  // namespace

std::vector<Seed> mesh_seeds() {
  const TriangleMesh box = mesh::triangulate(cube(Vec3(0.25, -1, 3))).mesh;
  const mesh::MeshColours colours = mesh::colours_by_quality(box, 0.5, 1.2);
  std::vector<Seed> result;
  for (const std::string name : {"a.off", "a.obj", "a.ply", "a.stl"})
    for (const bool text : {true, false})
      for (const bool coloured : {true, false}) {
        std::ostringstream out;
        mesh::write_mesh(out, *mesh::format_of_extension(name), box, {text, coloured ? &colours : nullptr});
        result.push_back({name, out.str()});
      }
  result.push_back(
      {"b.off",
       "# quads\nSTCNOFF 8 6 12\n0 0 0 1 1 1 1 1 1 1 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n"
       "4 0 2 3 1\n4 4 5 7 6 255 0 0\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n"});
  result.push_back(
      {"b.obj",
       "mtllib a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvn 0 0 1\ng a\nf 1/1/1 3/1/1 2/1/1\n"
       "f -4//1 -3//1 -1//1\nf 1/1 4/1 \\\n3/1\nf 2 3 4 # last\n"});
  result.push_back(
      {"b.ply",
       "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
       "property uchar red\nelement face 2\nproperty list uchar int vertex_indices\n"
       "property float quality\nelement edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n"
       "0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n3 0 1 2 0.5\n3 0 2 3 0.5\n0 1\n"});
  result.push_back(
      {"c.ply",
       "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
       "element tristrips 1\nproperty list int int64 vertex_indices\nend_header\n"
       "0 0 0 9\n2 0 0 9\n0 2 0 9\n0 0 2 9\n8 0 1 2 3\n-1 0 3 1\n"});
  // Cubes that share an edge and a square, a fin, and a face wrapped over lines.
  result.push_back(
      {"c.off",
       "OFF\n19 14 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n"
       "1 1 0\n2 1 0\n1 2 0\n2 2 0\n1 1 1\n2 1 1\n1 2 1\n2 2 1\n0.5 1 0\n9 9 9\n0 0 2\n"
       "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3\n7 5\n4 8 10 11 9\n4 12 13 15 14\n"
       "4 8 9 13 12\n4 10 14 15 11\n4 8 12 14 10\n4 9 11 15 13\n3 0 2 18\n3 2 0 18\n"});
  // A tube that goes on through its cell, and a cube with flat faces in those of its cell.
  const std::string ring = "1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n1 0 1\n0 1 1\n-1 0 1\n0 -1 1\n";
  result.push_back(
      {"d.off", "OFF\n# Lattice=\"4 0 0 0 4 0 0 0 1\" Origin=\"-2 -2 0\" pbc=\"F F T\"\n8 4 0\n" + ring +
                    "4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n"});
  result.push_back({"d.obj",
                    "# Lattice=\"1 0 0 0 3 0 0 0 3\"\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\n"
                    "v 0 1 1\nv 1 1 1\nf 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"});
  result.push_back({"d.ply",
                    "ply\nformat ascii 1.0\ncomment Lattice=\"4 0 0 1 4 0 0 0 1\" pbc=\"F F T\"\n"
                    "element vertex 8\nproperty double x\nproperty double y\nproperty double z\n"
                    "element face 4\nproperty list uchar int vertex_index\nend_header\n" +
                        ring + "4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n"});
  result.push_back({"e.off", binary_off(tetrahedron())});
  add_scenes_and_grids(result);
  return result;
}

}  // namespace nanocarbon::test
