// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/load_surface.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/formats/read_mesh.h"
#include "nanocarbon/mesh/repair/repair_surface.h"

namespace nanocarbon::mesh {
namespace {

//! What was found in a file, before it is sewn in a cell.
struct Examined {
  LoadedSurface surface;
  std::optional<Cell> cell;
  std::vector<std::string> mended;
};

bool has_reasons(const MeshDiagnosis& diagnosis) {
  return std::any_of(diagnosis.findings.begin(), diagnosis.findings.end(), [](const MeshFinding& finding) {
    return severity(finding.problem) == Severity::reason;
  });
}

Examined examine(const std::filesystem::path& path, const CellRequest& request, double close_holes) {
  Examined found;
  PolygonSoup soup = read_mesh(path);
  found.surface.vertices_read = soup.points.size();
  found.surface.faces_read = soup.faces();
  found.cell = requested_cell(request, soup);
  RepairedSurface repaired = repair_surface(std::move(soup), close_holes);
  found.mended = std::move(repaired.mended);
  found.surface.mesh = std::move(repaired.mesh);
  found.surface.repairs = std::move(repaired.repairs);
  found.surface.diagnosis = std::move(repaired.diagnosis);
  for (const MeshFinding& finding : found.surface.diagnosis.findings) {
    // Where a mesh was cut open for its cell, parts can meet in a point.
    if (found.cell && finding.problem == MeshProblem::duplicate_vertex) continue;
    if (severity(finding.problem) == Severity::warning) found.surface.warnings.push_back(finding.text);
  }
  return found;
}

void put_in_cell(Examined& found, const CellRequest& request, const std::filesystem::path& path) {
  if (!found.cell && request.cells != std::array<int, 3>{1, 1, 1})
    throw UserError(Failure::usage,
                    fmt::format("{}: the mesh is in free space, where there are no cells to repeat; "
                                "give --periodic or --cell",
                                path.string()));
  if (!found.cell) return;
  try {
    found.surface.mesh = in_cell(found.surface.mesh, *found.cell, request, found.surface.repairs);
  } catch (const UserError& error) {
    throw UserError(error.failure(), fmt::format("{}: {}", path.string(), error.what()));
  }
}

}  // namespace

LoadedSurface examine_surface(const std::filesystem::path& path, const CellRequest& cell) {
  Examined found = examine(path, cell, 0.0);
  if (!has_reasons(found.surface.diagnosis)) put_in_cell(found, cell, path);
  return std::move(found.surface);
}

LoadedSurface load_surface(const std::filesystem::path& path, const LoadOptions& options) {
  Examined found = examine(path, options.cell, options.close_holes);
  std::string reasons;
  for (const MeshFinding& finding : found.surface.diagnosis.findings)
    if (severity(finding.problem) == Severity::reason) reasons += "\n  - " + finding.text;
  if (!reasons.empty())
    throw UserError(Failure::unsuitable,
                    fmt::format("{}: the mesh cannot be used:{}", path.string(), reasons));
  if (!options.repair && !found.mended.empty())
    throw UserError(Failure::unsuitable,
                    fmt::format("{}: the mesh needs repairs, which --no-repair forbids:\n  - {}",
                                path.string(), fmt::join(found.mended, "\n  - ")));
  put_in_cell(found, options.cell, path);
  return std::move(found.surface);
}

}  // namespace nanocarbon::mesh
