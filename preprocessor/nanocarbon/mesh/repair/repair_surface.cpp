// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/repair_surface.h"

#include <fmt/format.h>

#include <utility>

#include "nanocarbon/mesh/diagnose.h"
#include "nanocarbon/mesh/drop_faces.h"
#include "nanocarbon/mesh/join_points.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/repair/close_holes.h"
#include "nanocarbon/mesh/repair/drop_folds.h"
#include "nanocarbon/mesh/repair/flip_slivers.h"
#include "nanocarbon/mesh/repair/sew_boundaries.h"
#include "nanocarbon/mesh/triangulate.h"
#include "nanocarbon/mesh/winding.h"

namespace nanocarbon::mesh {
namespace {

using Repairs = std::vector<std::string>;

void tell(Repairs& repairs, const char* what, std::size_t count) {
  if (count > 0) repairs.push_back(fmt::format("{}: {}", what, count));
}

// Which vertices are one is decided by their places in every format alike, as it has to be in STL, so that the
// same surface is the same mesh whatever file it comes in.
void join_and_drop(PolygonSoup& soup, Repairs& repairs) {
  const CoincidentPoints coincident = coincident_points(soup.points);
  if (coincident.duplicates > 0) join(soup, coincident);
  tell(repairs, "joined vertices to others at the same place", coincident.duplicates);
  // As far apart as single precision can tell, if at all.
  const CoincidentPoints ends = ends_of_short_edges(soup, 1e-7 * bounding_box(soup.points).diagonal());
  if (ends.duplicates > 0) join(soup, ends);
  tell(repairs, "joined the ends of edges without length", ends.duplicates);
  tell(repairs, "repaired or dropped faces that repeat a vertex", drop_repeated_vertices(soup));
  tell(repairs, "dropped duplicate faces", drop_copied_faces(soup));
  const DroppedFolds folds = drop_folds(soup);
  tell(repairs, "dropped faces folded onto each other", folds.of_fins);
  tell(repairs, "dropped the back faces of sheets given with both sides", folds.of_sheets);
}

void separate(PolygonSoup& soup, CrossingSheets crossing, Repairs& repairs) {
  const SeparatedSheets separated = separate_sheets(soup, crossing);
  tell(repairs, "separated sheets that met at edges", separated.edges);
  tell(repairs, "separated sheets that met at vertices", separated.vertices);
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

RepairedSurface repair_surface(PolygonSoup soup, double close_holes, CrossingSheets crossing) {
  RepairedSurface result;
  result.repairs = soup.notes;
  const auto tell_mended = [&] {
    result.repairs.insert(result.repairs.end(), result.mended.begin(), result.mended.end());
  };
  join_and_drop(soup, result.mended);
  if (auto sewed = sew_boundaries(soup)) result.mended.push_back(*sewed);
  separate(soup, crossing, result.mended);
  tell(result.mended, "dropped vertices that no face uses", drop_unused_points(soup));
  if (!can_be_triangulated(soup)) {
    tell_mended();
    result.diagnosis = diagnose(soup);
    return result;
  }
  Triangulated triangulated = triangulate(soup);
  result.mesh = std::move(triangulated.mesh);
  tell(result.repairs, "cut polygons into triangles", triangulated.polygons);
  tell(result.repairs, "added a vertex at the centre of polygons", triangulated.centres_added);
  wind_and_flip(result.mesh, result.mended);
  tell_mended();
  if (close_holes > 0.0) {
    const MeshTopology topology = mesh_topology(result.mesh);
    if (topology.manifold() && topology.consistently_wound())
      tell(result.repairs, "closed boundary loops as asked", mesh::close_holes(result.mesh, close_holes));
  }
  result.diagnosis = diagnose(soup_of(result.mesh));
  return result;
}

}  // namespace nanocarbon::mesh
