// SPDX-License-Identifier: GPL-2.0-or-later
#include "inspect.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "cell_options.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/diagnose.h"
#include "nanocarbon/mesh/diagnosis.h"
#include "nanocarbon/mesh/formats/load_surface.h"
#include "nanocarbon/mesh/formats/write_mesh.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/periodic_mesh.h"
#include "nanocarbon/mesh/repair/close_holes.h"
#include "nanocarbon/mesh/repair/drop_specks.h"
#include "nanocarbon/mesh/solid/advice.h"
#include "surface_input.h"

namespace nanocarbon::cli {
namespace {

using Json = nlohmann::ordered_json;

struct InspectCommand {
  std::string mesh;
  SurfaceOptions surface;
  CellOptions cell;
  std::optional<std::filesystem::path> write;
  bool json = false;
};

//! The mesh once repaired, and in its cell if it has one.
struct Inspection {
  mesh::LoadedSurface surface;
  std::optional<Cell> cell = {};             // that the mesh is in
  std::optional<TriangleMesh> in_cell = {};  // the mesh there, if it can be used
  std::vector<std::string> notes = {};
  std::string why_not = {};
  std::optional<mesh::MeshAdvice> advice = {};  // where it cannot be used, or crosses itself

  bool usable() const { return surface.diagnosis.usable() && (!cell || in_cell); }
};

Json findings_json(const mesh::MeshDiagnosis& diagnosis, mesh::Severity wanted) {
  Json list = Json::array();
  for (const mesh::MeshFinding& finding : diagnosis.findings) {
    if (mesh::severity(finding.problem) != wanted) continue;
    Json places = Json::array();
    for (const mesh::MeshPlace& place : finding.places)
      places.push_back({{"vertices", place.vertices},
                        {"faces", place.faces},
                        {"point", {place.point.x(), place.point.y(), place.point.z()}}});
    list.push_back({{"problem", name(finding.problem)},
                    {"count", finding.count},
                    {"text", finding.text},
                    {"places", std::move(places)}});
  }
  return list;
}

Json vector_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

// Components with so small a share of the area are hardly meant to be molecules.
constexpr double share_of_specks = 1e-3;

std::size_t specks_of(const mesh::LoadedSurface& surface) {
  const std::vector<double> areas = mesh::component_areas(surface.mesh);
  const double least = share_of_specks * std::accumulate(areas.begin(), areas.end(), 0.0);
  return static_cast<std::size_t>(
      std::count_if(areas.begin(), areas.end(), [&](double a) { return a < least; }));
}

// What the mesh is in its cell.
Json cell_json(const Inspection& inspection) {
  const Cell& cell = *inspection.cell;
  Json json = {{"vectors",
                {vector_json(cell.vectors.col(0)), vector_json(cell.vectors.col(1)),
                 vector_json(cell.vectors.col(2))}},
               {"origin", vector_json(cell.origin)},
               {"periodic", cell.periodic},
               {"notes", inspection.notes}};
  if (!inspection.in_cell) {
    json["reason"] = inspection.why_not;
    return json;
  }
  const mesh::MeshTopology t = mesh::mesh_topology(*inspection.in_cell);
  json.update({{"vertices", t.vertices},
               {"faces", t.faces},
               {"pieces", t.components},
               {"boundary_loops", t.boundary_loops},
               {"euler_characteristic", t.euler_characteristic},
               {"genus", t.genus},
               {"wrapping", mesh::wrapping_ranks(*inspection.in_cell, t)},
               {"area", mesh::area(*inspection.in_cell)}});
  return json;
}

void print_cell(const Inspection& inspection) {
  const auto line = [](std::string_view name, const std::string& value) {
    fmt::print("  {:<18}{}\n", name, value);
  };
  line("cell", describe_cell(*inspection.cell));
  for (const std::string& note : inspection.notes) line("in the cell", note);
  if (!inspection.in_cell) {
    if (!inspection.why_not.empty()) line("CANNOT BE USED", inspection.why_not);
    return;
  }
  const mesh::MeshTopology t = mesh::mesh_topology(*inspection.in_cell);
  constexpr const char* kinds[] = {"a bubble", "a tube", "a sheet", "a network"};
  std::string components;
  for (const int rank : mesh::wrapping_ranks(*inspection.in_cell, t))
    components += fmt::format("{}{}", components.empty() ? "" : ", ", kinds[rank]);
  line("in the cell",
       fmt::format("{} piece(s) ({}), {} boundary loops, genus {} (Euler characteristic {}), area {:.6g}",
                   t.components, components, t.boundary_loops, t.genus, t.euler_characteristic,
                   mesh::area(*inspection.in_cell)));
}

Json to_json(const std::string& file, const Inspection& inspection) {
  const mesh::LoadedSurface& surface = inspection.surface;
  const mesh::MeshDiagnosis& d = surface.diagnosis;
  const mesh::MeshTopology& t = d.topology;
  Json json = {{"file", file},
               {"as_read", {{"vertices", surface.vertices_read}, {"faces", surface.faces_read}}},
               {"vertices", d.points},
               {"faces", d.faces},
               {"edges", t.edges},
               {"pieces", t.components},
               {"boundary_loops", t.boundary_loops},
               {"manifold", t.manifold()},
               {"orientable", t.orientable},
               {"euler_characteristic", t.euler_characteristic},
               {"genus", t.genus},
               {"edge_lengths",
                {{"min", d.edges.min},
                 {"mean", d.edges.mean},
                 {"max", d.edges.max},
                 {"coefficient_of_variation", d.edges.coefficient_of_variation()}}},
               {"area", d.area},
               {"volume", d.volume ? Json(*d.volume) : Json()},
               {"unit", surface.unit.empty() ? Json() : Json(surface.unit)},
               {"bounding_box", {{"low", vector_json(d.box.low)}, {"high", vector_json(d.box.high)}}}};
  Json components = Json::array();
  for (const mesh::MeshComponent& p : t.component)
    components.push_back({{"vertices", p.vertices},
                          {"faces", p.faces},
                          {"boundary_loops", p.boundary_loops},
                          {"orientable", p.orientable},
                          {"genus", p.genus()}});
  json["piece"] = std::move(components);
  json["specks"] = specks_of(surface);
  if (inspection.cell) json["cell"] = cell_json(inspection);
  json["usable"] = inspection.usable();
  json["repairs"] = surface.repairs;
  json["warnings"] = findings_json(d, mesh::Severity::warning);
  json["reasons"] = findings_json(d, mesh::Severity::reason);
  if (inspection.advice)
    json["advice"] = {{"options", inspection.advice->options}, {"outcome", inspection.advice->outcome}};
  return json;
}

void print_text(const std::string& file, const Inspection& inspection) {
  const mesh::LoadedSurface& surface = inspection.surface;
  const mesh::MeshDiagnosis& d = surface.diagnosis;
  const mesh::MeshTopology& t = d.topology;
  const auto line = [](std::string_view name, const std::string& value) {
    fmt::print("  {:<18}{}\n", name, value);
  };
  fmt::print("{}\n", file);
  const bool as_read = d.points == surface.vertices_read && d.faces == surface.faces_read;
  line("vertices, faces",
       fmt::format("{}, {}", d.points, d.faces) +
           (as_read ? "" : fmt::format(" (in the file {}, {})", surface.vertices_read, surface.faces_read)));
  line("pieces", fmt::format("{}", t.components));
  line("boundary loops", fmt::format("{}", t.boundary_loops));
  line("orientable", t.orientable ? "yes" : "no");
  line("genus", t.manifold() ? fmt::format("{} (Euler characteristic {})", t.genus, t.euler_characteristic)
                             : std::string("not defined: not a manifold"));
  line("edge lengths", fmt::format("{:.6g} to {:.6g}, mean {:.6g}, deviation/mean {:.3f}", d.edges.min,
                                   d.edges.max, d.edges.mean, d.edges.coefficient_of_variation()));
  if (!d.box.empty()) {
    const Vec3 extent = d.box.extent();
    line("bounding box",
         fmt::format("{:.6g} x {:.6g} x {:.6g}", extent.x(), extent.y(), extent.z()) +
             (surface.unit.empty() ? "" : fmt::format(" (unit of the file: {})", surface.unit)));
  }
  line("area", fmt::format("{:.6g}", d.area) + (d.volume ? fmt::format(", volume {:.6g}", *d.volume) : ""));
  if (const std::size_t specks = specks_of(surface))
    line("specks", fmt::format("{} pieces have less than a thousandth of the area each: build --drop-specks "
                               "leaves out those too small for a cage of carbon",
                               specks));
  for (const std::string& repair : surface.repairs) line("repaired", repair);
  for (const mesh::MeshFinding& finding : d.findings) {
    if (mesh::severity(finding.problem) == mesh::Severity::warning) line("warning", finding.text);
    if (mesh::severity(finding.problem) == mesh::Severity::reason) line("CANNOT BE USED", finding.text);
  }
  if (inspection.cell) print_cell(inspection);
  if (inspection.advice)
    line(inspection.usable() ? "mended with" : "can be used with",
         fmt::format("{}: {}", inspection.advice->options, inspection.advice->outcome));
  if (inspection.usable()) line("usable", "yes: nanocarbon build accepts it");
}

Inspection examine(const InspectCommand& command, const mesh::CellRequest& request) {
  const SurfaceInput input = read_surface(command.mesh, command.surface, request);
  Inspection inspection{
      mesh::examine_surface(input.soup, command.mesh, request, command.surface.close_holes)};
  inspection.surface.vertices_read = input.vertices_read;
  inspection.surface.faces_read = input.faces_read;
  inspection.cell = inspection.surface.cell;
  const bool sound =
      inspection.usable() && !inspection.surface.diagnosis.find(mesh::MeshProblem::self_intersection);
  if (!inspection.cell && !sound) inspection.advice = mesh::advise(input.soup);
  return inspection;
}

void write(const std::filesystem::path& path, const Inspection& inspection) {
  if (inspection.in_cell && mesh::format_to_write(path) == mesh::MeshFormat::stl)
    throw UserError(Failure::usage,
                    fmt::format("{}: an STL file cannot hold a periodic cell; name an OFF, OBJ or PLY file",
                                path.string()));
  mesh::write_mesh(path, inspection.in_cell ? *inspection.in_cell : inspection.surface.mesh);
}

void run(const InspectCommand& command) {
  const mesh::CellRequest request = cell_request(command.cell);
  if (command.write) mesh::format_to_write(*command.write);
  Inspection inspection = examine(command, request);
  if (inspection.cell && inspection.surface.diagnosis.usable()) try {
      inspection.in_cell =
          mesh::in_cell(inspection.surface.mesh, *inspection.cell, request, inspection.notes);
      const double radius = command.surface.close_holes;
      if (const std::size_t closed = radius > 0.0 ? mesh::close_holes(*inspection.in_cell, radius) : 0)
        inspection.notes.push_back(fmt::format("closed boundary loops as asked: {}", closed));
      inspection.cell = *inspection.in_cell->space.cell();
      mesh::find_intersections_in_cell(*inspection.in_cell, inspection.surface.diagnosis);
    } catch (const UserError& error) {
      inspection.why_not = error.what();
    }
  if (command.json)
    fmt::print("{}\n", to_json(command.mesh, inspection).dump(2));
  else
    print_text(command.mesh, inspection);
  if (command.write && inspection.usable()) write(*command.write, inspection);
  if (!inspection.usable()) throw CLI::RuntimeError(static_cast<int>(Failure::unsuitable));
}

}  // namespace

void add_inspect(CLI::App& app) {
  CLI::App& sub = *app.add_subcommand(
      "inspect", "Describe a mesh as it is once repaired, with every reason why it cannot be used");
  const auto command = std::make_shared<InspectCommand>();
  sub.add_option("MESH", command->mesh,
                 "Mesh file (OFF, OBJ, PLY, STL, glTF, 3MF, VTK, MSH), or a scalar field with --level (cube, "
                 "MRC, VTI)")
      ->required();
  sub.add_flag("--json", command->json, "Print JSON");
  sub.add_option("--write", command->write,
                 "Also write the mesh as build would use it, as OFF, OBJ, PLY or STL; nothing where it "
                 "cannot be used")
      ->type_name("FILE");
  add_surface_options(
      *sub.add_option_group("Mesh", "Changes to the mesh before it is looked at, as in build"),
      command->surface);
  add_cell_options(sub, command->cell);
  sub.footer(R"(The exit code is 0 when nanocarbon build would take the mesh, 5 when it would not.
Examples:
  nanocarbon inspect scan.ply
  nanocarbon inspect part.stl --json
  nanocarbon inspect soup.stl --wrap 0.5 --write closed.ply
  nanocarbon inspect gyroid.stl --cell 10,10,10
  nanocarbon inspect density.cube --level 0.02 --periodic xyz)");
  sub.callback([command] { run(*command); });
}

}  // namespace nanocarbon::cli
