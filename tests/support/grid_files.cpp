// SPDX-License-Identifier: GPL-2.0-or-later
#include "support/grid_files.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "nanocarbon/mesh/parsing/byte_order.h"

namespace nanocarbon::test {
namespace {

std::string points_text(const TriangleMesh& mesh) {
  std::string text;
  for (const Vec3& p : mesh.points) text += fmt::format("{} {} {}\n", p.x(), p.y(), p.z());
  return text;
}

// With the first edge's index the fastest, or the last's.
std::string values_text(const SampledField& f, bool last_fastest) {
  std::string text;
  const auto [n0, n1, n2] = f.counts;
  for (std::size_t at = 0; at < n0 * n1 * n2; ++at) {
    const std::size_t i = last_fastest ? at / (n1 * n2) : at % n0,
                      j = last_fastest ? at / n2 % n1 : at / n0 % n1,
                      k = last_fastest ? at % n2 : at / (n0 * n1);
    const Vec3 index(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
    text += fmt::format("{}{}", static_cast<float>(f.value(f.origin + f.steps * index)),
                        at % 6 == 5 ? "\n" : " ");
  }
  return text + "\n";
}

}  // namespace

std::string vtk_text(const TriangleMesh& mesh) {
  std::string text =
      fmt::format("# vtk DataFile Version 3.0\na mesh\nASCII\nDATASET POLYDATA\nPOINTS {} double\n{}",
                  mesh.points.size(), points_text(mesh));
  text += fmt::format("POLYGONS {} {}\n", mesh.triangles.size(), 4 * mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) text += fmt::format("3 {} {} {}\n", a, b, c);
  return text + fmt::format("POINT_DATA {}\nSCALARS x int 1\nLOOKUP_TABLE default\n", mesh.points.size());
}

std::string vtp_text(const TriangleMesh& mesh) {
  std::string corners, ends;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    corners += fmt::format("{} {} {}\n", mesh.triangles[t][0], mesh.triangles[t][1], mesh.triangles[t][2]);
    ends += fmt::format("{} ", 3 * (t + 1));
  }
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" "
      "byte_order=\"LittleEndian\">\n<PolyData>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"{}\">\n"
      "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
      "format=\"ascii\">\n{}</DataArray></Points>\n"
      "<Polys><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">\n{}</DataArray>\n"
      "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">\n{}\n</DataArray></Polys>\n"
      "</Piece>\n</PolyData>\n</VTKFile>\n",
      mesh.points.size(), mesh.triangles.size(), points_text(mesh), corners, ends);
}

std::string msh_text(const TriangleMesh& mesh) {
  std::string text = fmt::format("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 {0} 1 {0}\n2 1 0 {0}\n",
                                 mesh.points.size());
  for (std::size_t i = 1; i <= mesh.points.size(); ++i) text += fmt::format("{}\n", i);
  text += points_text(mesh);
  text += fmt::format("$EndNodes\n$Elements\n1 {0} 1 {0}\n2 1 2 {0}\n", mesh.triangles.size());
  std::size_t number = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    text += fmt::format("{} {} {} {}\n", ++number, a + 1, b + 1, c + 1);
  return text + "$EndElements\n";
}

std::string cube_text(const SampledField& f, bool angstrom) {
  std::string text =
      fmt::format("a field\nof a test\n 1 {} {} {}\n", f.origin.x(), f.origin.y(), f.origin.z());
  for (int d = 0; d < 3; ++d)
    text += fmt::format(" {}{} {} {} {}\n", angstrom ? "-" : "", f.counts[static_cast<std::size_t>(d)],
                        f.steps(0, d), f.steps(1, d), f.steps(2, d));
  return text + " 6 6.0 0.0 0.0 0.0\n" + values_text(f, true);
}

std::string mrc_bytes(const SampledField& f, bool big_endian, std::array<int, 3> axes) {
  const mesh::ByteOrder order = big_endian ? mesh::ByteOrder::big : mesh::ByteOrder::little;
  std::string bytes(1024, '\0');
  const auto put = [&](std::size_t at, auto number) {
    const auto raw = mesh::bytes_of(number, order);
    bytes.replace(at, raw.size(), raw.data(), raw.size());
  };
  put(12, std::int32_t{2});
  for (std::size_t k = 0; k < 3; ++k) {
    const auto d = static_cast<std::size_t>(axes[k] - 1);
    const auto row = static_cast<int>(d), column = static_cast<int>(k);
    put(4 * k, static_cast<std::int32_t>(f.counts[d]));
    put(16 + 4 * k, static_cast<std::int32_t>(std::lround(f.origin[row] / f.steps(row, row))));
    put(28 + 4 * k, static_cast<std::int32_t>(f.counts[k]));
    put(40 + 4 * k, static_cast<float>(static_cast<double>(f.counts[k]) * f.steps(column, column)));
    put(52 + 4 * k, 90.0f);
    put(64 + 4 * k, static_cast<std::int32_t>(axes[k]));
  }
  put(88, std::int32_t{1});
  bytes.replace(208, 4, "MAP ");
  bytes.replace(212, 2, big_endian ? "\x11\x11" : "\x44\x44");
  std::array<std::size_t, 3> n{}, at{};
  for (std::size_t k = 0; k < 3; ++k) n[k] = f.counts[static_cast<std::size_t>(axes[k] - 1)];
  for (at[2] = 0; at[2] < n[2]; ++at[2])
    for (at[1] = 0; at[1] < n[1]; ++at[1])
      for (at[0] = 0; at[0] < n[0]; ++at[0]) {
        Vec3 index;
        for (std::size_t k = 0; k < 3; ++k) index[axes[k] - 1] = static_cast<double>(at[k]);
        const auto raw = mesh::bytes_of(static_cast<float>(f.value(f.origin + f.steps * index)), order);
        bytes.append(raw.data(), raw.size());
      }
  return bytes;
}

std::string vti_text(const SampledField& f) {
  const std::string extent = fmt::format("0 {} 0 {} 0 {}", f.counts[0] - 1, f.counts[1] - 1, f.counts[2] - 1);
  return fmt::format(
      "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\">\n<ImageData "
      "WholeExtent=\"{0}\" "
      "Origin=\"{1} {2} {3}\" Spacing=\"{4} {5} {6}\">\n<Piece Extent=\"{0}\">\n<PointData>\n"
      "<DataArray type=\"Float32\" Name=\"density\" "
      "format=\"ascii\">\n{7}</DataArray>\n</PointData>\n</Piece>\n"
      "</ImageData>\n</VTKFile>\n",
      extent, f.origin.x(), f.origin.y(), f.origin.z(), f.steps(0, 0), f.steps(1, 1), f.steps(2, 2),
      values_text(f, false));
}

std::string structured_points_text(const SampledField& f) {
  return fmt::format(
      "# vtk DataFile Version 2.0\na field\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS {} {} {}\nORIGIN {} "
      "{} {}\n"
      "SPACING {} {} {}\nPOINT_DATA {}\nSCALARS density float\nLOOKUP_TABLE default\n{}",
      f.counts[0], f.counts[1], f.counts[2], f.origin.x(), f.origin.y(), f.origin.z(), f.steps(0, 0),
      f.steps(1, 1), f.steps(2, 2), f.counts[0] * f.counts[1] * f.counts[2], values_text(f, false));
}

}  // namespace nanocarbon::test
