// SPDX-License-Identifier: GPL-2.0-or-later
#include "surface_input.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <utility>

#include "nanocarbon/core/error.h"
#include "nanocarbon/core/text_numbers.h"
#include "nanocarbon/mesh/formats/read_mesh.h"
#include "nanocarbon/mesh/repair/repair_surface.h"
#include "nanocarbon/mesh/solid/advice.h"
#include "nanocarbon/mesh/solid/repair_solids.h"
#include "nanocarbon/mesh/solid/unite.h"
#include "nanocarbon/mesh/solid/untangle.h"
#include "number_checks.h"

namespace nanocarbon::cli {
namespace {

std::optional<double> length(const std::string& text) {
  double value = 0.0;
  const bool is_length = read_real(text, value) == NumberToken::number && value > 0.0 && std::isfinite(value);
  return is_length ? std::optional(value) : std::nullopt;
}

mesh::WrapSize parsed_wrap_size(const std::string& text) {
  const std::size_t comma = text.find(',');
  const std::optional<double> size = length(text.substr(0, comma));
  const std::optional<double> offset =
      comma == text.npos ? std::optional(size.value_or(0.0) / mesh::WrapSize::sizes_in_offset)
                         : length(text.substr(comma + 1));
  if (!size || !offset)
    throw CLI::ValidationError("--wrap",
                               fmt::format("'{}' is not a size, or a size and an offset with a comma between "
                                           "them, above 0 in mesh units",
                                           text));
  return {*size, *offset};
}

mesh::PolygonSoup solid_soup(const TriangleMesh& mesh, std::vector<std::string> notes) {
  mesh::PolygonSoup soup = mesh::soup_of(mesh);
  soup.notes = std::move(notes);
  return soup;
}

mesh::PolygonSoup wrapped(const mesh::PolygonSoup& soup, const mesh::WrapSize& size) {
  const mesh::Wrapped wrapped = mesh::wrap(soup, size);
  std::vector<std::string> notes = soup.notes;
  notes.push_back(describe(wrapped, size));
  return solid_soup(wrapped.mesh, std::move(notes));
}

mesh::RepairedSolids repaired_as_one(const mesh::PolygonSoup& soup, double close_holes) {
  mesh::RepairedSurface repaired = mesh::repair_surface(soup, close_holes);
  const mesh::MeshTopology& topology = repaired.diagnosis.topology;
  const bool manifold = topology.manifold() && topology.orientable && !repaired.mesh.triangles.empty();
  return {std::move(repaired.mesh), std::move(repaired.repairs), manifold};
}

// Without crossings of pieces with themselves, or with each other, as asked.
mesh::PolygonSoup without_crossings(mesh::PolygonSoup soup, const SurfaceOptions& options) {
  mesh::RepairedSolids repaired = options.unite ? mesh::repair_solids(soup, options.close_holes)
                                                : repaired_as_one(soup, options.close_holes);
  if (!repaired.manifold) return soup;  // the reasons are told when it is used
  if (options.untangle) {
    mesh::Untangled untangled = mesh::untangle(repaired.mesh);
    repaired.repairs.push_back(describe(untangled));
    repaired.mesh = std::move(untangled.mesh);
  }
  if (!options.unite) return solid_soup(repaired.mesh, std::move(repaired.repairs));
  const mesh::United united = mesh::unite(repaired.mesh);
  repaired.repairs.push_back(describe(united));
  return solid_soup(united.mesh, std::move(repaired.repairs));
}

void add_field_options(CLI::App& group, mesh::FieldRequest& field) {
  group
      .add_option(
          "--level", field.level,
          "Where the file has a scalar field (cube, MRC, VTI) instead of a mesh: its value on the surface")
      ->type_name("VALUE");
  group.add_option("--field", field.array, "Which field, by name, where the file has several")
      ->type_name("NAME");
  const std::map<std::string, mesh::FieldEdge> edges = {{"closed", mesh::FieldEdge::closed},
                                                        {"above", mesh::FieldEdge::above},
                                                        {"below", mesh::FieldEdge::below},
                                                        {"open", mesh::FieldEdge::open}};
  group
      .add_option_function<std::string>(
          "--field-edge", [&field, edges](const std::string& name) { field.edge = edges.at(name); },
          "How that surface ends at the edges of the field that are not --periodic: around what is above the "
          "level, or, where all that is at the edges is above, around what is below (closed, default); "
          "around "
          "what is above or below in any case (above, below); with a boundary (open)")
      ->check(CLI::IsMember(edges))
      ->type_name("NAME");
}

}  // namespace

void add_surface_options(CLI::App& group, SurfaceOptions& o) {
  add_field_options(group, o.field);
  CLI::Option* holes = group
                           .add_option("--close-holes", o.close_holes,
                                       "Close boundary loops with a radius below this, mesh units")
                           ->check(above_zero());
  CLI::Option* unite = group.add_flag(
      "--unite", o.unite, "Make pieces that overlap one: each a closed solid (boolean union, by CGAL)");
  CLI::Option* untangle = group.add_flag(
      "--untangle", o.untangle,
      "New triangles where a piece crosses itself in a few places; refused where that would take more than a "
      "small part of it (by CGAL)");
  group
      .add_option_function<std::string>(
          "--wrap", [&o](const std::string& text) { o.wrap = parsed_wrap_size(text); },
          "Put a closed surface around whatever the mesh is, which does not enter gaps narrower than this "
          "and lies "
          "an offset outside of it, a 30th of the size if not given; mesh units (alpha wrap, by CGAL)")
      ->type_name("SIZE[,OFFSET]")
      ->excludes(unite)
      ->excludes(untangle)
      ->excludes(holes);
}

SurfaceInput read_surface(const std::filesystem::path& path, const SurfaceOptions& options,
                          const mesh::CellRequest& cell) {
  SurfaceInput input{mesh::read_mesh(path, mesh::field_in_cell(options.field, cell))};
  input.vertices_read = input.soup.points.size();
  input.faces_read = input.soup.faces();
  if (!options.wrap && !options.unite && !options.untangle) return input;
  try {
    if (requested_cell(cell, input.soup))
      throw UserError(
          Failure::usage,
          "--wrap, --unite and --untangle know free space only: --periodic none leaves the cell out");
    input.soup =
        options.wrap ? wrapped(input.soup, *options.wrap) : without_crossings(std::move(input.soup), options);
  } catch (const UserError& error) {
    throw UserError(error.failure(), fmt::format("{}: {}", path.string(), error.what()));
  }
  return input;
}

mesh::LoadedSurface load_surface(const std::filesystem::path& path, const SurfaceOptions& options,
                                 bool repair, const mesh::CellRequest& cell) {
  const SurfaceInput input = read_surface(path, options, cell);
  try {
    mesh::LoadedSurface surface = mesh::load_surface(
        input.soup, path, {.repair = repair, .close_holes = options.close_holes, .cell = cell});
    surface.vertices_read = input.vertices_read;
    surface.faces_read = input.faces_read;
    return surface;
  } catch (const UserError& error) {
    if (error.failure() != Failure::unsuitable || !repair || requested_cell(cell, input.soup)) throw;
    const std::optional<mesh::MeshAdvice> advice = mesh::advise(input.soup);
    if (!advice) throw;
    throw UserError(error.failure(), fmt::format("{}\nIt can be used with {} ({})", error.what(),
                                                 advice->options, advice->outcome));
  }
}

}  // namespace nanocarbon::cli
