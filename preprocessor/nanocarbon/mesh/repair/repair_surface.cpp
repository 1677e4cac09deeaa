// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/repair_surface.h"

#include <fmt/format.h>

#include <utility>

#include "nanocarbon/mesh/diagnose.h"
#include "nanocarbon/mesh/drop_faces.h"
#include "nanocarbon/mesh/join_points.h"
#include "nanocarbon/mesh/repair/flip_slivers.h"
#include "nanocarbon/mesh/repair/join_seams.h"
#include "nanocarbon/mesh/triangulate.h"
#include "nanocarbon/mesh/winding.h"

namespace nanocarbon::mesh {
namespace {

using Repairs = std::vector<std::string>;

void tell(Repairs& repairs, const char* what, std::size_t count) {
  if (count > 0) repairs.push_back(fmt::format("{}: {}", what, count));
}

void wind_and_flip(TriangleMesh& mesh, Repairs& repairs) {
  const PolygonSoup soup = soup_of(mesh);
  const EdgeTable edges = edge_table(soup);
  const MeshTopology topology = mesh_topology(soup, edges);
  if (!topology.manifold()) return;  // which way round is not known
  tell(repairs, "turned faces that were wound against the others", wind_alike(mesh, topology, edges));
  tell(repairs, "turned closed pieces that were inside-out", turn_outside(mesh, topology));
  if (topology.orientable) tell(repairs, "flipped edges of faces without area", flip_slivers(mesh));
}

}  // namespace

RepairedSurface repair_surface(PolygonSoup soup) {
  RepairedSurface result;
  result.repairs = soup.notes;
  Repairs& repairs = result.repairs;
  if (auto joined = join_seams(soup)) repairs.push_back(*joined);
  tell(repairs, "mended or dropped faces that repeat a vertex", drop_repeated_vertices(soup));
  tell(repairs, "dropped second copies of faces", drop_copied_faces(soup));
  tell(repairs, "dropped vertices that no face uses", drop_unused_points(soup));
  if (!can_be_triangulated(soup)) {
    result.diagnosis = diagnose(soup);
    return result;
  }
  Triangulated triangulated = triangulate(soup);
  result.mesh = std::move(triangulated.mesh);
  tell(repairs, "cut polygons into triangles", triangulated.polygons);
  tell(repairs, "added a vertex at the centre of polygons", triangulated.centres_added);
  wind_and_flip(result.mesh, repairs);
  result.diagnosis = diagnose(soup_of(result.mesh));
  return result;
}

}  // namespace nanocarbon::mesh
