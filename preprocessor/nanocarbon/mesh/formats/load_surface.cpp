// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/load_surface.h"

#include <fmt/format.h>

#include <utility>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/formats/read_mesh.h"
#include "nanocarbon/mesh/repair/repair_surface.h"

namespace nanocarbon::mesh {

LoadedSurface load_surface(const std::filesystem::path& path) {
  RepairedSurface repaired = repair_surface(read_mesh(path));
  LoadedSurface surface{
      std::move(repaired.mesh), std::move(repaired.repairs), {}, std::move(repaired.diagnosis)};
  std::string reasons;
  for (const MeshFinding& finding : surface.diagnosis.findings) {
    if (severity(finding.problem) == Severity::reason) reasons += "\n  - " + finding.text;
    if (severity(finding.problem) == Severity::warning) surface.warnings.push_back(finding.text);
  }
  if (!reasons.empty())
    throw UserError(Failure::unsuitable,
                    fmt::format("{}: the mesh cannot be used:{}", path.string(), reasons));
  return surface;
}

}  // namespace nanocarbon::mesh
