// SPDX-License-Identifier: GPL-2.0-or-later
#include "inspect.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/diagnose.h"
#include "nanocarbon/mesh/diagnosis.h"
#include "nanocarbon/mesh/formats/read_mesh.h"
#include "nanocarbon/mesh/repair/repair_surface.h"

namespace nanocarbon::cli {
namespace {

using Json = nlohmann::ordered_json;

struct InspectCommand {
  std::string mesh;
  bool json = false;
};

//! The file as it is, and what repairs would make of it.
struct Inspection {
  mesh::MeshDiagnosis diagnosis;
  mesh::RepairedSurface repaired;
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

Json to_json(const std::string& file, const Inspection& inspection) {
  const mesh::MeshDiagnosis& d = inspection.diagnosis;
  const mesh::MeshTopology& t = d.topology;
  Json json = {{"file", file},
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
  json["usable"] = inspection.repaired.diagnosis.usable();
  json["repairs"] = inspection.repaired.repairs;
  json["warnings"] = findings_json(inspection.repaired.diagnosis, mesh::Severity::warning);
  json["reasons"] = findings_json(inspection.repaired.diagnosis, mesh::Severity::reason);
  return json;
}

void print_text(const std::string& file, const Inspection& inspection) {
  const mesh::MeshDiagnosis& d = inspection.diagnosis;
  const mesh::MeshTopology& t = d.topology;
  const auto line = [](std::string_view name, const std::string& value) {
    fmt::print("  {:<18}{}\n", name, value);
  };
  fmt::print("{}\n", file);
  line("vertices, faces", fmt::format("{}, {}", d.points, d.faces));
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
  for (const std::string& repair : inspection.repaired.repairs) line("repaired", repair);
  for (const mesh::MeshFinding& finding : inspection.repaired.diagnosis.findings) {
    if (mesh::severity(finding.problem) == mesh::Severity::warning) line("warning", finding.text);
    if (mesh::severity(finding.problem) == mesh::Severity::reason) line("CANNOT BE USED", finding.text);
  }
  if (inspection.repaired.diagnosis.usable()) line("usable", "yes: nanocarbon build takes it");
}

void run(const InspectCommand& command) {
  mesh::PolygonSoup soup = mesh::read_mesh(command.mesh);
  Inspection inspection{mesh::diagnose(soup), {}};
  inspection.repaired = mesh::repair_surface(std::move(soup));
  if (command.json)
    fmt::print("{}\n", to_json(command.mesh, inspection).dump(2));
  else
    print_text(command.mesh, inspection);
  if (!inspection.repaired.diagnosis.usable()) throw CLI::RuntimeError(static_cast<int>(Failure::unsuitable));
}

}  // namespace

void add_inspect(CLI::App& app) {
  CLI::App& sub =
      *app.add_subcommand("inspect", "Tell what a mesh is, and every reason why it could not be used");
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
