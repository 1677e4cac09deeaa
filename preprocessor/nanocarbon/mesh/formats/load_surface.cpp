// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/load_surface.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <utility>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/diagnose.h"
#include "nanocarbon/mesh/formats/read_mesh.h"
#include "nanocarbon/mesh/repair/close_holes.h"
#include "nanocarbon/mesh/repair/repair_surface.h"

namespace nanocarbon::mesh {
namespace {

//! What of a mesh's cell, which the file may say, is refused without knowing of a file: with its name.
template <class Take>
auto naming_file(const std::filesystem::path& path, const Take& take) {
  try {
    return take();
  } catch (const UserError& error) {
    throw UserError(error.failure(), fmt::format("{}: {}", path.string(), error.what()));
  }
}

std::vector<std::string> warnings(const MeshDiagnosis& diagnosis) {
  std::vector<std::string> texts;
  for (const MeshFinding& finding : diagnosis.findings)
    if (severity(finding.problem) == Severity::warning) texts.push_back(finding.text);
  return texts;
}

void require_usable(const std::filesystem::path& path, const MeshDiagnosis& diagnosis) {
  std::string reasons;
  for (const MeshFinding& finding : diagnosis.findings)
    if (severity(finding.problem) == Severity::reason) reasons += "\n  - " + finding.text;
  if (!reasons.empty())
    throw UserError(Failure::unsuitable,
                    fmt::format("{}: the mesh cannot be used:{}", path.string(), reasons));
}

LoadedSurface examine(PolygonSoup soup, const std::filesystem::path& path, const CellRequest& request,
                      double close_holes, std::vector<std::string>& mended) {
  LoadedSurface surface;
  surface.vertices_read = soup.points.size();
  surface.faces_read = soup.faces();
  surface.unit = soup.unit;
  surface.cell = naming_file(path, [&] { return requested_cell(request, soup); });
  // A mesh that is cut at its cell has loops there that are no holes: they are closed once it is sewn.
  RepairedSurface repaired = repair_surface(std::move(soup), surface.cell ? 0.0 : close_holes);
  mended = std::move(repaired.mended);
  surface.mesh = std::move(repaired.mesh);
  surface.repairs = std::move(repaired.repairs);
  surface.diagnosis = std::move(repaired.diagnosis);
  if (surface.cell) drop_findings_of_the_cut(surface.diagnosis);
  surface.warnings = warnings(surface.diagnosis);
  return surface;
}

}  // namespace

LoadedSurface examine_surface(const std::filesystem::path& path, const CellRequest& cell) {
  return examine_surface(read_mesh(path), path, cell);
}

LoadedSurface examine_surface(PolygonSoup soup, const std::filesystem::path& path, const CellRequest& cell,
                              double close_holes) {
  std::vector<std::string> mended;
  return examine(std::move(soup), path, cell, close_holes, mended);
}

LoadedSurface load_surface(const std::filesystem::path& path, const LoadOptions& options) {
  return load_surface(read_mesh(path, field_in_cell(options.field, options.cell)), path, options);
}

LoadedSurface load_surface(PolygonSoup soup, const std::filesystem::path& path, const LoadOptions& options) {
  std::vector<std::string> mended;
  LoadedSurface surface = examine(std::move(soup), path, options.cell, options.close_holes, mended);
  require_usable(path, surface.diagnosis);
  if (!options.repair && !mended.empty())
    throw UserError(Failure::unsuitable,
                    fmt::format("{}: the mesh needs repairs, which --no-repair forbids:\n  - {}",
                                path.string(), fmt::join(mended, "\n  - ")));
  if (!surface.cell && options.cell.cells != std::array<int, 3>{1, 1, 1})
    throw UserError(Failure::usage,
                    fmt::format("{}: the mesh is in free space, where there are no cells to repeat; "
                                "give --periodic or --cell",
                                path.string()));
  if (!surface.cell) return surface;
  surface.mesh =
      naming_file(path, [&] { return in_cell(surface.mesh, *surface.cell, options.cell, surface.repairs); });
  if (options.close_holes > 0.0) {
    const std::size_t closed =
        naming_file(path, [&] { return close_holes(surface.mesh, options.close_holes); });
    if (closed > 0) surface.repairs.push_back(fmt::format("closed boundary loops as asked: {}", closed));
  }
  find_intersections_in_cell(surface.mesh, surface.diagnosis);
  require_usable(path, surface.diagnosis);
  surface.warnings = warnings(surface.diagnosis);
  return surface;
}

}  // namespace nanocarbon::mesh
