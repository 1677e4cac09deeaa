// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/solid/untangle.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/diagnose.h"
#include "nanocarbon/mesh/distance.h"
#include "nanocarbon/mesh/join_points.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/repair/repair_surface.h"
#include "nanocarbon/mesh/solid/cgal_version.h"
#include "nanocarbon/mesh/solid/mend_crossings.h"
#include "nanocarbon/mesh/solid/mesh_parts.h"

namespace nanocarbon::mesh {
namespace {

constexpr std::size_t most_crossings =
    2000;                          // more are no small fault, and filling their holes takes minutes
constexpr double most_area = 0.2;  // replaced, of all
constexpr double farthest = 0.05;  // of new faces from the mesh, in diagonals

[[noreturn]] void refuse(const MeshFinding& crossing, const std::string& why) {
  const Vec3& at = crossing.places[0].point;
  throw UserError(
      Failure::unsuitable,
      fmt::format("--untangle: {} pair{} of faces of a piece intersect{}, first at ({:.6g}, {:.6g}, {:.6g}), "
                  "and {}; --wrap SIZE puts a closed surface around anything",
                  crossing.count, crossing.count == 1 ? "" : "s", crossing.count == 1 ? "s" : "", at.x(),
                  at.y(), at.z(), why));
}

// Faces at no vertex that lies on another: where parts of a surface touch in vertices and edges, they do not intersect, but
// a search for intersections that knows of no such vertices takes them to.
std::vector<FaceIndex> faces_that_touch_none(const TriangleMesh& mesh) {
  const std::vector<VertexIndex> place = coincident_points(mesh.points).representative;
  std::vector<bool> shared(mesh.points.size(), false);
  for (VertexIndex v = 0; v < mesh.points.size(); ++v)
    if (place[v] != v) shared[v] = shared[place[v]] = true;
  std::vector<FaceIndex> faces;
  for (FaceIndex face = 0; face < mesh.triangles.size(); ++face) {
    const auto& [a, b, c] = mesh.triangles[face];
    if (!shared[a] && !shared[b] && !shared[c]) faces.push_back(face);
  }
  return faces;
}

using FacePlace = std::array<std::array<double, 3>, 3>;

FacePlace place_of(const TriangleMesh& mesh, const Triangle& triangle) {
  FacePlace place;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& p = mesh.points[triangle[k]];
    place[k] = {p.x(), p.y(), p.z()};
  }
  std::sort(place.begin(), place.end());
  return place;
}

// The faces of one mesh that another lacks.
TriangleMesh faces_lacking(const TriangleMesh& mesh, const TriangleMesh& other) {
  std::set<FacePlace> there;
  for (const Triangle& triangle : other.triangles) there.insert(place_of(other, triangle));
  std::vector<FaceIndex> lacking;
  for (FaceIndex face = 0; face < mesh.triangles.size(); ++face)
    if (!there.contains(place_of(mesh, mesh.triangles[face]))) lacking.push_back(face);
  return part_of(mesh, lacking);
}

double largest_distance(const TriangleMesh& from, const TriangleMesh& to) {
  if (from.triangles.empty()) return 0.0;
  return std::max(distance_between(from, to).there.max, distances_of_area(from, to).max);
}

bool same_surface(const MeshTopology& one, const MeshTopology& other) {
  return one.components == other.components && one.genus == other.genus &&
         one.boundary_loops == other.boundary_loops && one.orientable == other.orientable;
}

// Nothing where crossings are left.
std::optional<TriangleMesh> try_to_mend(const TriangleMesh& piece, const std::vector<FaceIndex>& examined,
                                        Handles handles) {
  const std::optional<TriangleMesh> found = mend_crossings(piece, examined, handles);
  if (!found) return {};
  RepairedSurface repaired = repair_surface(soup_of(*found));  // new triangles may be slivers
  const MeshDiagnosis& diagnosis = repaired.diagnosis;
  if (!diagnosis.usable() || diagnosis.find(MeshProblem::self_intersection) ||
      diagnosis.find(MeshProblem::search_given_up))
    return {};
  // A cavity stays one: its faces look inwards.
  if (mesh_topology(piece).closed() && signed_volume(piece) * signed_volume(repaired.mesh) < 0)
    for (Triangle& t : repaired.mesh.triangles) std::swap(t[1], t[2]);
  return std::move(repaired.mesh);
}

// A component without its crossings, and what that took, added to what it took before.
TriangleMesh mended(const TriangleMesh& piece, const MeshDiagnosis& before, Untangled& all) {
  const MeshFinding& crossing = *before.find(MeshProblem::self_intersection);
  if (crossing.count > most_crossings || before.find(MeshProblem::search_given_up))
    refuse(crossing, "so many are no small fault: parts of it pass through each other");
  const std::vector<FaceIndex> examined = faces_that_touch_none(piece);
  std::optional<TriangleMesh> found = try_to_mend(piece, examined, Handles::keep);
  if (!found) {
    found = try_to_mend(piece, examined, Handles::give_away);
    if (found) {
      const MeshTopology after = mesh_topology(*found);
      refuse(crossing,
             fmt::format(
                 "a surface without them would have other handles, or come apart: {} piece(s) of genus {} "
                 "and {} boundary loops, not 1 of genus {} and {}",
                 after.components, after.genus, after.boundary_loops, before.topology.genus,
                 before.topology.boundary_loops));
    }
    refuse(crossing,
           fmt::format("none of the surfaces that were tried in place of the faces around them is without "
                       "intersections{}",
                       examined.size() < piece.triangles.size()
                           ? "; faces at vertices that lie on others were left as they are"
                           : ""));
  }
  const MeshTopology after = mesh_topology(*found);
  if (!same_surface(before.topology, after))
    refuse(crossing, "a surface without them would not have the piece's genus and boundaries");
  const TriangleMesh gone = faces_lacking(piece, *found), put = faces_lacking(*found, piece);
  const double share = area(gone) / before.area;
  if (share > most_area)
    refuse(crossing,
           fmt::format(
               "a surface without them would replace {:.0f}% of the piece: that is more than a small fault",
               100.0 * share));
  const double to_original = largest_distance(put, piece);
  // Where what was pulled through is cut off, new faces lie as far from the rest as they are long.
  if (to_original > std::max(farthest * before.box.diagonal(), edge_lengths(put).max))
    refuse(crossing, fmt::format("a surface without them would lie up to {:.3g} off the mesh, which is "
                                 "{:.3g} from corner to corner",
                                 to_original, before.box.diagonal()));
  ++all.components;
  all.crossings += crossing.count;
  all.replaced += gone.triangles.size();
  all.to_original = std::max(all.to_original, to_original);
  all.from_original = std::max(all.from_original, largest_distance(gone, *found));
  return *std::move(found);
}

}  // namespace

Untangled untangle(const TriangleMesh& mesh) {
  // Says how to get it.
  if (std::string_view(cgal_version()).empty()) mend_crossings(mesh, {}, Handles::keep);
  const MeshTopology topology = mesh_topology(mesh);
  std::vector<std::vector<FaceIndex>> faces(topology.components);
  for (FaceIndex face = 0; face < mesh.triangles.size(); ++face)
    faces[topology.component_of_face[face]].push_back(face);
  Untangled untangled;
  for (const std::vector<FaceIndex>& component : faces) {
    const TriangleMesh piece = part_of(mesh, component);
    const MeshDiagnosis diagnosis = diagnose(soup_of(piece));
    const bool crosses =
        diagnosis.find(MeshProblem::self_intersection) && !diagnosis.find(MeshProblem::no_area);
    append(untangled.mesh, crosses ? mended(piece, diagnosis, untangled) : piece);
  }
  return untangled;
}

std::string describe(const Untangled& untangled) {
  if (untangled.components == 0) return "untangled nothing: no piece crosses itself";
  return fmt::format(
      "untangled {} piece{} of {} intersections: new triangles in place of {}, nowhere farther than {:.3g} "
      "from "
      "the mesh, and the mesh nowhere farther than {:.3g} from them (mesh units)",
      untangled.components, untangled.components == 1 ? "" : "s", untangled.crossings, untangled.replaced,
      untangled.to_original, untangled.from_original);
}

}  // namespace nanocarbon::mesh
