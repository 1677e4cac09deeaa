// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/build_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "nanocarbon/building/gaussian_curvature_kept.h"
#include "nanocarbon/core/version.h"
#include "nanocarbon/mesh/distance.h"
#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/periodic_mesh.h"
#include "nanocarbon/molecule/bond_statistics.h"
#include "nanocarbon/molecule/boundary_units.h"
#include "nanocarbon/molecule/hydrogens.h"
#include "nanocarbon/molecule/ring_mesh.h"
#include "nanocarbon/potential/rebo2/parameters.h"

namespace nanocarbon::building {
namespace {

using Json = nlohmann::ordered_json;

Json topology_json(const TriangleMesh& mesh) {
  const mesh::MeshTopology t = mesh::mesh_topology(mesh);
  return {{"vertices", t.vertices},
          {"faces", t.faces},
          {"pieces", t.components},
          {"boundary_loops", t.boundary_loops},
          {"orientable", t.orientable},
          {"euler_characteristic", t.euler_characteristic},
          {"genus", t.genus}};
}

Json lengths_json(std::span<const double> lengths, const molecule::Interval& interval) {
  const molecule::LengthStatistics s = molecule::length_statistics(lengths, interval);
  const double count = std::max<double>(1.0, static_cast<double>(s.lengths.count));
  return {{"count", s.lengths.count},
          {"min", s.lengths.min},
          {"mean", s.lengths.mean},
          {"max", s.lengths.max},
          {"standard_deviation", s.lengths.deviation},
          {"interval", {interval.low, interval.high}},
          {"fraction_short", static_cast<double>(s.below) / count},
          {"fraction_long", static_cast<double>(s.above) / count},
          {"fraction_outside", s.fraction_outside},
          {"histogram", {{"from", interval.low}, {"to", interval.high}, {"counts", s.histogram}}}};
}

std::vector<double> edge_lengths_of(const TriangleMesh& mesh) {
  const mesh::EdgeTable edges = mesh::edge_table(mesh::soup_of(mesh));
  std::vector<double> lengths(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e)
    lengths[e] = mesh.space.displacement(mesh.points[edges.high[e]], mesh.points[edges.low[e]]).norm();
  return lengths;
}

Json rings_json(const Rings& rings) {
  std::map<std::size_t, std::size_t> by_size;
  for (std::size_t r = 0; r < rings.size(); ++r) ++by_size[rings[r].size()];
  Json json = Json::object();
  for (const auto& [size, count] : by_size) json[std::to_string(size)] = count;
  return json;
}

std::size_t rings_outside_5_to_7(const Rings& rings) {
  std::size_t outside = 0;
  for (std::size_t r = 0; r < rings.size(); ++r) outside += rings[r].size() < 5 || rings[r].size() > 7;
  return outside;
}

Json distance_json(const mesh::DistanceStatistics& d) {
  return {{"mean", d.mean}, {"rms", d.rms}, {"max", d.max}};
}

Json thesis_json(const thesis::ThesisRecord& r) {
  Json history = Json::array();
  for (const thesis::EdgeCounts& c : r.history) history.push_back({c.edges, c.too_short, c.too_long});
  return {{"iterations", r.iterations},
          {"stopped", thesis::to_string(r.stop)},
          {"short_edges", r.edges.too_short},
          {"long_edges", r.edges.too_long},
          {"steps",
           {{"collapses", r.stellar.collapses},
            {"splits", r.stellar.splits},
            {"flips", r.valence.flips},
            {"low_pass_iterations", r.low_pass_iterations},
            {"local_iterations", r.local_iterations},
            {"local_optimisations", r.local.minimised},
            {"post_processed", r.post_processing.minimised},
            {"projection_replacements", r.projection_replacements}}},
          {"seconds",
           {{"stellar", r.seconds.stellar},
            {"valence", r.seconds.valence},
            {"low_pass", r.seconds.low_pass},
            {"local", r.seconds.local},
            {"projection", r.seconds.projection},
            {"post_processing", r.seconds.post_processing},
            {"total", r.seconds.total}}},
          {"history", {{"columns", {"edges", "short", "long"}}, {"rows", std::move(history)}}}};
}

Json annealed_json(const RestingState& rest, const AnnealingRecord& r) {
  return {{"energy_per_atom", rest.energy},
          {"above_graphene", rest.above_graphene},
          {"above_graphene_unannealed", r.unannealed_energy - rebo2::graphene_energy},
          {"max_force", rest.max_force},
          {"closest_unbonded", rest.closest_unbonded},
          {"rebo2_sees_these_bonds", rest.intact},
          {"refinements", r.refinements},
          {"bond_switches", r.accepted}};
}

std::string formula(std::size_t carbons, std::size_t hydrogens) {
  return fmt::format("C{}", carbons) + (hydrogens > 0 ? fmt::format("H{}", hydrogens) : "");
}

// Of a thesis's dual nothing has been minimised, and its boundary has no energy.
// Whether a stiffer tether or a draft, which keeps the disclinations of its triangulation, may keep more of a form.
bool has_unbent(double curvature_kept, const Json& options) {
  constexpr double most_of_it = 0.8, stiff = 1.0;
  return curvature_kept < most_of_it && options.contains("tether") &&
         options["tether"].get<double>() < stiff && options["quality"] != "draft";
}

Json boundary_json(const BuildResult& result, const BuildOptions& options) {
  const molecule::BoundaryUnits units =
      result.boundary ? result.boundary->units : molecule::boundary_units(result.molecule);
  const double atoms = static_cast<double>(std::max<std::size_t>(units.open_atoms, 1));
  Json chains = Json::object();
  for (std::size_t size = 0; size < units.chains.size(); ++size)
    if (units.chains[size] > 0) chains[std::to_string(size)] = units.chains[size];
  Json json = {{"kind", name(result.annealed ? options.boundary : Boundary::bare)},
               {"length", units.length},
               {"open_atoms", units.open_atoms},
               {"dead_ends", units.dead_ends},
               {"zigzag", static_cast<double>(units.zigzag) / atoms},
               {"armchair", static_cast<double>(units.armchair) / atoms},
               {"other", static_cast<double>(units.others()) / atoms},
               {"chains_by_size", chains}};
  const std::optional<double> kept = gaussian_curvature_kept(result.triangulation, result.surface.mesh);
  json["gaussian_curvature_kept"] = kept ? Json(*kept) : Json();
  if (result.boundary) {
    json["energy"] = result.boundary->energy;
    json["energy_per_length"] = result.boundary->energy / std::max(units.length, 1e-9);
  }
  return json;
}

// To the faces of the molecule's rings.
mesh::DistanceStatistics surface_to_atoms(const Molecule& carbon, const TriangleMesh& surface) {
  const TriangleMesh rings = molecule::ring_mesh(carbon);
  return rings.triangles.empty() ? mesh::DistanceStatistics{} : mesh::distances_of_area(surface, rings);
}

Json certificate_json(const minimisation::Certificate& c) {
  return {{"minimum", c.minimum()},       {"max_force", c.max_force}, {"smallest_eigenvalues", c.eigenvalues},
          {"uncertainty", c.uncertainty}, {"complete", c.complete},   {"saddles_left", c.pushes}};
}

Json options_json(const BuildResult& result, const BuildOptions& o) {
  Json json = {{"recipe", name(o.recipe)}, {"atoms_aimed_at", result.surface.atoms}};
  if (result.annealed) {
    constexpr const char* qualities[] = {"draft", "good", "best"};
    json.update({{"potential", name(o.potential)},
                 {"quality", qualities[static_cast<int>(o.quality)]},
                 {"boundary", name(o.boundary)},
                 {"bond_length", o.bond_length},
                 {"tether", tether_of(o)},
                 {"force_tolerance", o.force_tolerance}});
  } else {
    json.update({{"min_bond", o.thesis.min_bond},
                 {"max_bond", o.thesis.max_bond},
                 {"iterations", o.thesis.iterations},
                 {"rings", o.thesis.rings},
                 {"projection_interval", o.thesis.projection_interval},
                 {"local_threshold", o.thesis.local_threshold},
                 {"visited", o.thesis.marks == thesis::VisitedMarks::either_end ? "either" : "both"}});
  }
  json.update({{"threads", o.threads}, {"seed", o.seed}});
  return json;
}

// The cell at the end, what was done to it, and how the pieces go through it.
Json cell_json(const BuildResult& result, const BuildOptions& options) {
  constexpr double gigapascal = 160.21766208;      // of 1 eV/Angstrom^3
  constexpr double grams_per_cm3 = 1.66053906660;  // of 1 g/mol/Angstrom^3
  const Cell& cell = *result.molecule.cell;
  const auto row = [](const Vec3& v) { return Json{v[0], v[1], v[2]}; };
  const auto matrix = [&](const Mat3& m) { return Json{row(m.row(0)), row(m.row(1)), row(m.row(2))}; };
  const Mat3& m = cell.vectors;
  const auto angle = [&](int i, int j) {
    return std::acos(m.col(i).dot(m.col(j)) / (m.col(i).norm() * m.col(j).norm())) * 180 / std::numbers::pi;
  };
  Json json = {
      {"vectors", {row(m.col(0)), row(m.col(1)), row(m.col(2))}},
      {"origin", row(cell.origin)},
      {"periodic", cell.periodic},
      {"lengths", {m.col(0).norm(), m.col(1).norm(), m.col(2).norm()}},
      {"angles", {angle(1, 2), angle(0, 2), angle(0, 1)}},
      {"volume", volume(cell)},
      {"wrapping", mesh::wrapping_ranks(result.triangulation, mesh::mesh_topology(result.triangulation))}};
  if (cell.periodic == std::array<bool, 3>{true, true, true}) {
    double mass_sum = 0.0;
    for (const Element element : result.molecule.elements) mass_sum += mass(element);
    json["density"] = mass_sum / volume(cell) * grams_per_cm3;
  }
  if (result.annealed) {
    json["relaxed"] = minimisation::name(relaxed_strains(options, result.surface.mesh));
    json["deformation"] = matrix(result.annealed->deformation);
    json["stress"] = matrix(result.annealed->stress * gigapascal);
  }
  return json;
}

}  // namespace

Json build_report(const BuildResult& result, const BuildOptions& options, const ReportContext& context) {
  const Molecule& molecule = result.molecule;
  const Molecule carbon = molecule::carbon_skeleton(molecule);
  const mesh::MeshTopology topology = mesh::mesh_topology(result.triangulation);
  const molecule::Interval bonds{options.thesis.min_bond, options.thesis.max_bond};
  const molecule::Interval edges{std::sqrt(3.0) * bonds.low, std::sqrt(3.0) * bonds.high};
  const molecule::Spread angles = molecule::spread(molecule::bond_angles(carbon));

  const auto stage = StageClock::stage(options.clock, "report");
  Json report;
  report["nanocarbon"] = version;
  report["command"] = context.command;
  report["input"] = {{"file", context.input}, {"repairs", context.repairs}, {"scale", result.surface.scale}};
  report["input"].update(topology_json(result.surface.mesh));
  report["options"] = options_json(result, options);
  if (molecule.cell) report["cell"] = cell_json(result, options);
  report["molecule"] = {{"atoms", molecule.size()},
                        {"carbon", carbon.size()},
                        {"hydrogen", molecule.size() - carbon.size()},
                        {"formula", formula(carbon.size(), molecule.size() - carbon.size())},
                        {"bonds", molecule.bonds.size()},
                        {"rings", molecule.rings.size()},
                        {"rings_by_size", rings_json(molecule.rings)},
                        {"rings_outside_5_to_7", rings_outside_5_to_7(molecule.rings)},
                        {"pieces", topology.components},
                        {"euler_characteristic", topology.euler_characteristic},
                        {"genus", topology.genus},
                        {"boundary_loops", topology.boundary_loops}};
  if (topology.boundary_loops > 0) report["boundary"] = boundary_json(result, options);
  report["bond_lengths"] = lengths_json(molecule::bond_lengths(carbon), bonds);
  report["bond_angles"] = {{"mean", angles.mean},
                           {"standard_deviation", angles.deviation},
                           {"min", angles.min},
                           {"max", angles.max}};
  report["triangulation_edges"] = lengths_json(edge_lengths_of(result.triangulation), edges);
  const mesh::SurfaceDistance triangulation =
      mesh::distance_between(result.triangulation, result.surface.mesh);
  report["distance"] = {{"atoms_to_surface", distance_json(mesh::distances_to_surface(
                                                 carbon.positions, mesh::NearestPoint(result.surface.mesh)))},
                        {"surface_to_atoms", distance_json(surface_to_atoms(carbon, result.surface.mesh))},
                        {"surface_to_triangulation", distance_json(triangulation.back)},
                        {"triangulation_to_surface", distance_json(triangulation.there)}};
  if (result.annealed) report["annealing"] = annealed_json(*result.rest, *result.annealed);
  if (result.likeness)
    report["likeness"] = {{"shape_radius", result.likeness->shape_radius},
                          {"distance_to_radius", result.likeness->distance_share},
                          {"sphere_to_radius", result.likeness->from_sphere / result.likeness->shape_radius},
                          {"turned_away", result.likeness->turned_away},
                          {"expected_above_graphene", result.likeness->expected_energy},
                          {"above_graphene_to_expected", result.likeness->energy_share},
                          {"warnings", result.likeness->warnings()}};
  if (result.certificate) report["certificate"] = certificate_json(*result.certificate);
  if (result.thesis) report["remeshing"] = thesis_json(*result.thesis);
  report["seconds"] = {{"remeshing", result.seconds.remeshing},
                       {"molecule", result.seconds.molecule},
                       {"total", result.seconds.total}};
  return report;
}

Json stages_json(const StageClock& clock) {
  Json json = Json::object();
  for (const StageClock::Time& time : clock.times())
    json[time.name] = {{"wall", time.wall}, {"cpu", time.cpu}};
  return json;
}

std::string report_table(const Json& report) {
  std::string table;
  const auto line = [&](std::string_view name, const std::string& value) {
    table += fmt::format("  {:<24}{}\n", name, value);
  };
  const Json& m = report["molecule"];
  std::string rings;
  for (const auto& [size, count] : m["rings_by_size"].items())
    rings += fmt::format("{}{}: {}", rings.empty() ? "" : ", ", size, count.get<std::size_t>());
  line("atoms, bonds", fmt::format("{} ({}), {}", m["atoms"].get<std::size_t>(),
                                   m["formula"].get<std::string>(), m["bonds"].get<std::size_t>()));
  line("rings by size", rings);
  line("topology",
       fmt::format("{} piece(s), genus {}, Euler characteristic {}, {} boundary loop(s), as in the input",
                   m["pieces"].get<std::size_t>(), m["genus"].get<std::int64_t>(),
                   m["euler_characteristic"].get<std::int64_t>(), m["boundary_loops"].get<std::size_t>()));
  if (report.contains("boundary")) {
    const Json& b = report["boundary"];
    std::string boundary =
        fmt::format("{}, {:.0f} A: {:.0f}% zigzag, {:.0f}% armchair, {:.0f}% other",
                    b["kind"].get<std::string>(), b["length"].get<double>(), 100 * b["zigzag"].get<double>(),
                    100 * b["armchair"].get<double>(), 100 * b["other"].get<double>());
    if (b.contains("energy"))
      boundary +=
          fmt::format("; {:.3f} eV/A above graphene and benzene's C-H", b["energy_per_length"].get<double>());
    if (!b["gaussian_curvature_kept"].is_null()) {
      const double kept = b["gaussian_curvature_kept"].get<double>();
      boundary += fmt::format("; {:.0f}% of the shape's Gaussian curvature kept", 100 * kept);
      if (has_unbent(kept, report["options"]))
        boundary += " (--tether 1 or --quality draft may keep more, at a higher energy)";
    }
    line("boundary", boundary);
  }
  const auto lengths = [&](const char* key) {
    const Json& l = report[key];
    return fmt::format("{:.3f} to {:.3f}, mean {:.4f}, deviation {:.4f}; {:.2f}% short, {:.2f}% long",
                       l["min"].get<double>(), l["max"].get<double>(), l["mean"].get<double>(),
                       l["standard_deviation"].get<double>(), 100 * l["fraction_short"].get<double>(),
                       100 * l["fraction_long"].get<double>());
  };
  if (report.contains("cell")) {
    const Json& c = report["cell"];
    std::string cell =
        fmt::format("{:.4f} x {:.4f} x {:.4f}, angles {:.3f}, {:.3f}, {:.3f}", c["lengths"][0].get<double>(),
                    c["lengths"][1].get<double>(), c["lengths"][2].get<double>(),
                    c["angles"][0].get<double>(), c["angles"][1].get<double>(), c["angles"][2].get<double>());
    if (c.contains("density")) cell += fmt::format(", {:.4f} g/cm3", c["density"].get<double>());
    line("cell, A", cell);
    if (c.contains("stress")) {
      double largest = 0.0;
      for (const Json& row : c["stress"])
        for (const Json& value : row) largest = std::max(largest, std::abs(value.get<double>()));
      line("stress, GPa",
           fmt::format("at most {:.2g}; strains freed: {}", largest, c["relaxed"].get<std::string>()));
    }
  }
  line("bonds, A", lengths("bond_lengths"));
  line("triangulation edges, A", lengths("triangulation_edges"));
  line("bond angles, degrees",
       fmt::format("mean {:.2f}, deviation {:.2f}", report["bond_angles"]["mean"].get<double>(),
                   report["bond_angles"]["standard_deviation"].get<double>()));
  const auto distances = [&](const char* key) {
    const Json& d = report["distance"][key];
    return fmt::format("mean {:.3f}, rms {:.3f}, max {:.3f}", d["mean"].get<double>(), d["rms"].get<double>(),
                       d["max"].get<double>());
  };
  const bool compared = report.contains("likeness");
  line("distance to surface, A", distances("atoms_to_surface"));
  line("... of surface, A",
       distances("surface_to_atoms") +
           (compared ? fmt::format("; the larger mean is {:.1f}% of the shape's radius",
                                   100 * report["likeness"]["distance_to_radius"].get<double>())
                     : ""));
  if (report.contains("remeshing")) {
    const Json& r = report["remeshing"];
    line("remeshing",
         fmt::format("{} iterations, {}", r["iterations"].get<unsigned>(), r["stopped"].get<std::string>()));
  }
  if (report.contains("annealing")) {
    const Json& r = report["annealing"];
    // The energy on fixed bonds leaves out part of what boundaries cost.
    const bool closed = report["molecule"]["boundary_loops"].get<std::size_t>() == 0;
    line("energy, eV/atom",
         fmt::format("{:.5f}, {:.1f} meV above graphene", r["energy_per_atom"].get<double>(),
                     1e3 * r["above_graphene"].get<double>()) +
             (closed ? fmt::format(" (before annealing {:.1f})",
                                   1e3 * r["above_graphene_unannealed"].get<double>())
                     : ""));
    if (compared)
      line("energy expected, meV",
           fmt::format(
               "{:.1f} above graphene for the shape's curvature and boundary; the molecule has {:.2f} times "
               "that",
               1e3 * report["likeness"]["expected_above_graphene"].get<double>(),
               report["likeness"]["above_graphene_to_expected"].get<double>()));
    line("largest force, eV/A", fmt::format("{:.1e}", r["max_force"].get<double>()));
  }
  if (report.contains("certificate")) {
    const Json& c = report["certificate"];
    std::string eigenvalues;
    for (const Json& value : c["smallest_eigenvalues"])
      eigenvalues += fmt::format("{:.3g} ", value.get<double>());
    line("certificate",
         fmt::format("{}; smallest eigenvalues of the Hessian {}eV/A^2",
                     c["minimum"].get<bool>() ? "a minimum" : "NOT SHOWN TO BE A MINIMUM", eigenvalues));
  }
  line("seconds", fmt::format("{:.2f}", report["seconds"]["total"].get<double>()));
  return table;
}

}  // namespace nanocarbon::building
