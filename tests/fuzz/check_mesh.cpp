// SPDX-License-Identifier: GPL-2.0-or-later
#include "fuzz/check_mesh.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/formats/cell_request.h"
#include "nanocarbon/mesh/formats/read_mesh.h"
#include "nanocarbon/mesh/grids/read_cube.h"
#include "nanocarbon/mesh/grids/read_mrc.h"
#include "nanocarbon/mesh/grids/read_vtk_xml.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/repair/repair_surface.h"

namespace nanocarbon::test {
namespace {

std::string broken_by_soup(const mesh::PolygonSoup& soup) {
  if (!std::all_of(soup.points.begin(), soup.points.end(), [](const Vec3& p) { return p.allFinite(); }))
    return "a point is not finite";
  if (!std::all_of(soup.corners.begin(), soup.corners.end(),
                   [&](VertexIndex v) { return v < soup.points.size(); }))
    return "a corner is out of range";
  if (soup.offsets.front() != 0 || soup.offsets.back() != soup.corners.size())
    return "the offsets do not fit the corners";
  for (std::size_t face = 0; face < soup.faces(); ++face)
    if (soup.offsets[face] + 3 > soup.offsets[face + 1]) return "a face has fewer than three corners";
  return {};
}

// What is true of a usable mesh in free space and in a cell.
std::string broken_by_topology(const TriangleMesh& mesh, const mesh::MeshTopology& topology) {
  if (mesh.triangles.empty()) return "a usable mesh has no triangles";
  const std::string broken = broken_by_soup(mesh::soup_of(mesh));
  if (!broken.empty()) return broken;
  if (!topology.manifold()) return "a usable mesh is not manifold";
  if (!topology.orientable || !topology.consistently_wound()) return "a usable mesh is not wound alike";
  if (topology.vertices != mesh.points.size()) return "a usable mesh has unused vertices";
  return {};
}

// What LoadedSurface promises, asked of the mesh itself.
std::string broken_by_surface(const TriangleMesh& mesh) {
  const mesh::MeshTopology topology = mesh::mesh_topology(mesh);
  if (const std::string broken = broken_by_topology(mesh, topology); !broken.empty()) return broken;
  std::int64_t euler = 0;
  for (const mesh::MeshComponent& component : topology.component) {
    euler += component.euler_characteristic();
    const auto loops = static_cast<std::int64_t>(component.boundary_loops);
    if (component.genus() < 0 || component.euler_characteristic() != 2 - 2 * component.genus() - loops)
      return "Euler's formula";
  }
  if (euler != topology.euler_characteristic) return "Euler's formula over the pieces";
  // A surface that crosses itself may have no volume, but for rounding.
  double farthest = 0.0;
  for (const Vec3& p : mesh.points) farthest = std::max(farthest, p.norm());
  const double rounding = 1e-14 * static_cast<double>(mesh.triangles.size()) * std::pow(farthest, 3);
  if (topology.components == 1 && topology.closed() && mesh::signed_volume(mesh) < -rounding)
    return "a usable mesh is inside-out";
  return {};
}

// The same for a mesh that is sewn in its cell, where it can be. load_surface() names the file where not.
std::string broken_in_cell(const TriangleMesh& mesh, const Cell& cell) {
  std::vector<std::string> notes;
  try {
    const TriangleMesh sewn = mesh::in_cell(mesh, cell, {}, notes);
    return broken_by_topology(sewn, mesh::mesh_topology(sewn));
  } catch (const UserError&) {
    return {};
  }
}

std::string broken_with_cell(const mesh::PolygonSoup& soup) {
  std::optional<Cell> cell;
  try {
    cell = mesh::requested_cell({}, soup);
  } catch (const UserError&) {
    return {};
  }
  mesh::RepairedSurface repaired = mesh::repair_surface(soup);
  if (cell) mesh::drop_findings_of_the_cut(repaired.diagnosis);
  if (!repaired.diagnosis.usable()) return {};
  return cell ? broken_in_cell(repaired.mesh, *cell) : broken_by_surface(repaired.mesh);
}

std::string broken_by_field(const mesh::ScalarField& field) {
  if (field.values.size() != field.counts[0] * field.counts[1] * field.counts[2])
    return "the values do not fill the grid";
  const bool finite =
      std::all_of(field.values.begin(), field.values.end(), [](float v) { return std::isfinite(v); });
  return finite ? "" : "a value is not finite";
}

// Making the surface of a field takes up to a thousand times as long as reading it.
std::string broken_by_reading(std::string_view contents, const std::string& file,
                              const mesh::FieldRequest& field) {
  if (file.ends_with(".cube")) return broken_by_field(mesh::read_cube(contents, file, field.array));
  if (file.ends_with(".mrc")) return broken_by_field(mesh::read_mrc(contents, file));
  if (file.ends_with(".vti")) {
    const mesh::GridContents grid = mesh::read_vtk_xml(contents, file, field.array);
    if (const auto* values = std::get_if<mesh::ScalarField>(&grid)) return broken_by_field(*values);
    return broken_by_soup(std::get<mesh::PolygonSoup>(grid));
  }
  return broken_by_soup(mesh::parse_mesh(contents, file, field));
}

}  // namespace

std::string broken_promise(std::string_view contents, const std::string& file, Depth depth) {
  try {
    mesh::FieldRequest field;
    if (file.ends_with(".cube") || file.ends_with(".mrc") || file.ends_with(".vti")) field.level = 0.5;
    if (depth == Depth::reading) return broken_by_reading(contents, file, field);
    const mesh::PolygonSoup soup = mesh::parse_mesh(contents, file, field);
    const std::string broken = broken_by_soup(soup);
    return broken.empty() ? broken_with_cell(soup) : broken;
  } catch (const UserError& error) {
    return std::string_view(error.what()).find(file) == std::string_view::npos
               ? "the message does not name the file"
               : "";
  }
}

}  // namespace nanocarbon::test
