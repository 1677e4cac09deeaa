// SPDX-License-Identifier: GPL-2.0-or-later
#include "inspect.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <vector>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/diagnosis.h"
#include "nanocarbon/mesh/formats/load_surface.h"
#include "nanocarbon/mesh/repair/drop_specks.h"

namespace nanocarbon::cli {
namespace {

using Json = nlohmann::ordered_json;

struct InspectCommand {
  std::string mesh;
  bool json = false;
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

// Pieces with so small a share of the area are hardly meant to be molecules.
constexpr double share_of_specks = 1e-3;

std::size_t specks_of(const mesh::LoadedSurface& surface) {
  const std::vector<double> areas = mesh::piece_areas(surface.mesh);
  const double least = share_of_specks * std::accumulate(areas.begin(), areas.end(), 0.0);
  return static_cast<std::size_t>(
      std::count_if(areas.begin(), areas.end(), [&](double a) { return a < least; }));
}

Json to_json(const std::string& file, const mesh::LoadedSurface& surface) {
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
  json["usable"] = d.usable();
  json["repairs"] = surface.repairs;
  json["warnings"] = findings_json(d, mesh::Severity::warning);
  json["reasons"] = findings_json(d, mesh::Severity::reason);
  return json;
}

void print_text(const std::string& file, const mesh::LoadedSurface& surface) {
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
    line("bounding box", fmt::format("{:.6g} x {:.6g} x {:.6g}", extent.x(), extent.y(), extent.z()));
  }
  line("area", fmt::format("{:.6g}", d.area) + (d.volume ? fmt::format(", volume {:.6g}", *d.volume) : ""));
  if (const std::size_t specks = specks_of(surface))
    line("specks",
         fmt::format("{} pieces have less than a thousandth of the area each: build --drop-specks leaves "
                     "out those without room for a cage of carbon",
                     specks));
  for (const std::string& repair : surface.repairs) line("repaired", repair);
  for (const mesh::MeshFinding& finding : d.findings) {
    if (mesh::severity(finding.problem) == mesh::Severity::warning) line("warning", finding.text);
    if (mesh::severity(finding.problem) == mesh::Severity::reason) line("CANNOT BE USED", finding.text);
  }
  if (d.usable()) line("usable", "yes: nanocarbon build takes it");
}

void run(const InspectCommand& command) {
  const mesh::LoadedSurface surface = mesh::examine_surface(command.mesh);
  if (command.json)
    fmt::print("{}\n", to_json(command.mesh, surface).dump(2));
  else
    print_text(command.mesh, surface);
  if (!surface.diagnosis.usable()) throw CLI::RuntimeError(static_cast<int>(Failure::unsuitable));
}

}  // namespace

void add_inspect(CLI::App& app) {
  CLI::App& sub = *app.add_subcommand(
      "inspect", "Tell what a mesh is once repaired, and every reason why it could not be used");
  const auto command = std::make_shared<InspectCommand>();
  sub.add_option("MESH", command->mesh, "Mesh file: OFF, OBJ, PLY or STL, text or binary")->required();
  sub.add_flag("--json", command->json, "Print JSON");
  sub.footer(R"(The exit code is 0 when nanocarbon build would take the mesh, 5 when it would not.
Examples:
  nanocarbon inspect scan.ply
  nanocarbon inspect part.stl --json)");
  sub.callback([command] { run(*command); });
}

}  // namespace nanocarbon::cli
