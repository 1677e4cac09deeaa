#include "nanocarbon/mesh/surface.h"

#include <fmt/format.h>

#include <utility>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/drop_faces.h"
#include "nanocarbon/mesh/flip_slivers.h"
#include "nanocarbon/mesh/join_points.h"
#include "nanocarbon/mesh/join_seams.h"
#include "nanocarbon/mesh/read_mesh.h"
#include "nanocarbon/mesh/triangulate.h"
#include "nanocarbon/mesh/winding.h"

namespace nanocarbon {
namespace {

void wind_and_flip(TriangleMesh& mesh, std::vector<std::string>& repairs) {
  const PolygonSoup soup = soup_of(mesh);
  const EdgeTable edges = edge_table(soup);
  const MeshTopology topology = mesh_topology(soup, edges);
  if (!topology.manifold()) return;  // which way round is not known
  if (const std::size_t turned = wind_alike(mesh, topology, edges); turned > 0)
    repairs.push_back(fmt::format("turned {} faces that were wound against the others", turned));
  if (const std::size_t turned = turn_outside(mesh, topology); turned > 0)
    repairs.push_back(topology.pieces == 1 ? std::string("turned the mesh, which was inside-out")
                                           : fmt::format("turned {} pieces that were inside-out", turned));
  if (!topology.orientable) return;
  if (const std::size_t flipped = flip_slivers(mesh); flipped > 0)
    repairs.push_back(fmt::format("flipped {} edges of faces without area", flipped));
}

}  // namespace

RepairedSurface repair_surface(PolygonSoup soup) {
  RepairedSurface result;
  result.repairs = soup.notes;
  auto& repairs = result.repairs;
  if (auto joined = join_seams(soup)) repairs.push_back(*joined);
  if (const std::size_t dropped = drop_faces_repeating_a_vertex(soup); dropped > 0)
    repairs.push_back(fmt::format("dropped {} faces that repeat a vertex", dropped));
  if (const std::size_t dropped = drop_copied_faces(soup); dropped > 0)
    repairs.push_back(fmt::format("dropped {} faces that are copies of others", dropped));
  if (const std::size_t dropped = drop_unused_points(soup); dropped > 0)
    repairs.push_back(fmt::format("dropped {} vertices that no face uses", dropped));

  if (!can_be_triangulated(soup)) {
    result.diagnosis = diagnose(soup);
    return result;
  }
  Triangulated triangulated = triangulate(soup);
  result.mesh = std::move(triangulated.mesh);
  if (triangulated.polygons > 0)
    repairs.push_back(fmt::format("cut {} polygons into triangles", triangulated.polygons));
  if (triangulated.centres_added > 0)
    repairs.push_back(fmt::format("added a vertex at the centre of {} polygons", triangulated.centres_added));
  wind_and_flip(result.mesh, repairs);
  result.diagnosis = diagnose(soup_of(result.mesh));
  return result;
}

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

}  // namespace nanocarbon
