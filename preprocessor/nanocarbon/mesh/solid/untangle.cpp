// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/solid/untangle.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/distance.h"
#include "nanocarbon/mesh/join_points.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/repair/repair_surface.h"
#include "nanocarbon/mesh/self_intersections.h"
#include "nanocarbon/mesh/solid/cgal_version.h"
#include "nanocarbon/mesh/solid/mend_crossings.h"
#include "nanocarbon/mesh/solid/mesh_parts.h"

namespace nanocarbon::mesh {
namespace {

constexpr std::size_t most_crossings =
    2000;                          // more are no small fault, and filling their holes takes minutes
constexpr double most_area = 0.2;  // replaced, of all
constexpr double farthest = 0.05;  // of new faces from the mesh, in diagonals

// Rings of faces around those that intersect: what may be replaced lies well within.
constexpr int rings_around = 12;

//! A component that crosses itself.
struct CrossingPiece {
  TriangleMesh mesh;
  std::vector<std::array<FaceIndex, 2>> pairs;
  bool complete = true;  //!< false where the search for them was given up
};

[[noreturn]] void refuse(const CrossingPiece& piece, const std::string& why) {
  const std::size_t count = piece.pairs.size();
  const auto [a, b, c] = corners_of(piece.mesh, piece.mesh.triangles[piece.pairs[0][0]]);
  const Vec3 at = (a + b + c) / 3.0;
  throw UserError(
      Failure::unsuitable,
      fmt::format("--untangle: {} pair{} of faces of a piece intersect{}, first at ({:.6g}, {:.6g}, {:.6g}), "
                  "and {}; --wrap SIZE puts a closed surface around anything",
                  count, count == 1 ? "" : "s", count == 1 ? "s" : "", at.x(), at.y(), at.z(), why));
}

// Of each vertex whether another one lies on it.
std::vector<bool> shared_places(const TriangleMesh& mesh) {
  const std::vector<VertexIndex> place = coincident_points(mesh.points).representative;
  std::vector<bool> shared(mesh.points.size(), false);
  for (VertexIndex v = 0; v < mesh.points.size(); ++v)
    if (place[v] != v) shared[v] = shared[place[v]] = true;
  return shared;
}

// The faces that intersect others with some rings of faces around them, ascending.
std::vector<FaceIndex> surroundings(const CrossingPiece& piece, int rings) {
  const std::vector<Triangle>& triangles = piece.mesh.triangles;
  std::vector<bool> inside(triangles.size(), false);
  for (const auto& pair : piece.pairs)
    for (const FaceIndex face : pair) inside[face] = true;
  std::vector<bool> reached(piece.mesh.points.size(), false);
  for (int ring = 0; ring < rings; ++ring) {
    for (FaceIndex face = 0; face < triangles.size(); ++face)
      if (inside[face])
        for (const VertexIndex v : triangles[face]) reached[v] = true;
    for (FaceIndex face = 0; face < triangles.size(); ++face)
      for (const VertexIndex v : triangles[face]) inside[face] = inside[face] || reached[v];
  }
  std::vector<FaceIndex> faces;
  for (FaceIndex face = 0; face < triangles.size(); ++face)
    if (inside[face]) faces.push_back(face);
  return faces;
}

using Place = std::array<double, 3>;
using FacePlace = std::array<Place, 3>;

Place place_of(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

FacePlace place_of(const TriangleMesh& mesh, const Triangle& triangle) {
  FacePlace place;
  for (std::size_t k = 0; k < 3; ++k) place[k] = place_of(mesh.points[triangle[k]]);
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
  std::vector<Vec3> points = sample_by_area(from, std::max<std::size_t>(10 * from.triangles.size(), 1000));
  points.insert(points.end(), from.points.begin(), from.points.end());
  return distances_to_surface(points, NearestPoint(to)).max;
}

bool same_surface(const MeshTopology& one, const MeshTopology& other) {
  return one.components == other.components && one.genus == other.genus &&
         one.boundary_loops == other.boundary_loops && one.orientable == other.orientable;
}

bool crosses_itself(const TriangleMesh& mesh) {
  const SelfIntersections found = crossings(mesh, coincident_points(mesh.points).representative);
  return !found.pairs.empty() || !found.complete;
}

// Nothing where crossings are left.
std::optional<TriangleMesh> try_to_mend(const TriangleMesh& part, const std::vector<FaceIndex>& examined,
                                        Handles handles) {
  const std::optional<TriangleMesh> found = mend_crossings(part, examined, handles);
  if (!found) return {};
  RepairedSurface repaired = repair_surface(soup_of(*found));  // new triangles may be slivers
  const MeshDiagnosis& diagnosis = repaired.diagnosis;
  if (!diagnosis.usable() || diagnosis.find(MeshProblem::self_intersection) ||
      diagnosis.find(MeshProblem::search_given_up))
    return {};
  // A cavity stays one: its faces look inwards.
  if (mesh_topology(part).closed() && signed_volume(part) * signed_volume(repaired.mesh) < 0)
    for (Triangle& t : repaired.mesh.triangles) std::swap(t[1], t[2]);
  return std::move(repaired.mesh);
}

// A mesh with other faces in place of some; nothing where these do not end at the same edges, wound the same way.
std::optional<TriangleMesh> put_back(const TriangleMesh& mesh, const std::vector<FaceIndex>& replaced,
                                     const TriangleMesh& by) {
  std::vector<bool> gone(mesh.triangles.size(), false), beside(mesh.points.size(), false);
  for (const FaceIndex face : replaced) gone[face] = true;
  TriangleMesh whole{mesh.points, {}};
  for (FaceIndex face = 0; face < mesh.triangles.size(); ++face) {
    if (gone[face]) continue;
    whole.triangles.push_back(mesh.triangles[face]);
    for (const VertexIndex v : mesh.triangles[face]) beside[v] = true;
  }
  std::map<Place, VertexIndex> seam;
  for (const FaceIndex face : replaced)
    for (const VertexIndex v : mesh.triangles[face]) {
      if (!beside[v]) continue;
      const auto [found, is_new] = seam.try_emplace(place_of(mesh.points[v]), v);
      if (!is_new && found->second != v) return {};
    }
  std::vector<VertexIndex> number;
  for (const Vec3& p : by.points) {
    const auto found = seam.find(place_of(p));
    number.push_back(found != seam.end() ? found->second : static_cast<VertexIndex>(whole.points.size()));
    if (found == seam.end()) whole.points.push_back(p);
  }
  for (const auto& [a, b, c] : by.triangles) whole.triangles.push_back({number[a], number[b], number[c]});
  drop_unused_points(whole);
  const MeshTopology topology = mesh_topology(whole);
  if (!topology.manifold() || !topology.consistently_wound()) return {};
  return whole;
}

// What mending part of a piece comes to.
struct Mended {
  TriangleMesh part;   // as it was
  TriangleMesh found;  // in its place
  TriangleMesh whole;  // the piece with it
};

std::optional<Mended> mend_within(const TriangleMesh& piece, const std::vector<FaceIndex>& faces,
                                  const std::vector<bool>& shared, Handles handles) {
  std::vector<FaceIndex> examined;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const auto& [a, b, c] = piece.triangles[faces[k]];
    if (!shared[a] && !shared[b] && !shared[c]) examined.push_back(static_cast<FaceIndex>(k));
  }
  Mended result{part_of(piece, faces), {}, {}};
  auto found = try_to_mend(result.part, examined, handles);
  if (!found) return {};
  result.found = *std::move(found);
  if (faces.size() == piece.triangles.size()) {
    result.whole = result.found;
    return result;
  }
  auto whole = put_back(piece, faces, result.found);
  if (!whole || crosses_itself(*whole)) return {};
  result.whole = *std::move(whole);
  return result;
}

std::vector<FaceIndex> all_faces(const TriangleMesh& mesh) {
  std::vector<FaceIndex> faces(mesh.triangles.size());
  std::iota(faces.begin(), faces.end(), FaceIndex{0});
  return faces;
}

// A component without its crossings, and what that took, added to what it took before.
TriangleMesh mended(const CrossingPiece& piece, Untangled& all) {
  if (piece.pairs.size() > most_crossings || !piece.complete)
    refuse(piece, "so many are no small fault: parts of it pass through each other");
  const MeshTopology before = mesh_topology(piece.mesh);
  const std::vector<bool> shared = shared_places(piece.mesh);
  // Around the crossings alone, which does not grow with the mesh; all of it where that is not enough.
  std::optional<Mended> found;
  const std::vector<FaceIndex> around = surroundings(piece, rings_around), all_of_it = all_faces(piece.mesh);
  if (around.size() < all_of_it.size()) found = mend_within(piece.mesh, around, shared, Handles::keep);
  if (!found) found = mend_within(piece.mesh, all_of_it, shared, Handles::keep);
  if (!found) {
    found = mend_within(piece.mesh, all_of_it, shared, Handles::give_away);
    if (found) {
      const MeshTopology after = mesh_topology(found->whole);
      refuse(piece,
             fmt::format(
                 "a surface without them would have other handles, or come apart: {} piece(s) of genus {} "
                 "and {} boundary loops, not 1 of genus {} and {}",
                 after.components, after.genus, after.boundary_loops, before.genus, before.boundary_loops));
    }
    const bool left_some = std::find(shared.begin(), shared.end(), true) != shared.end();
    refuse(piece,
           fmt::format("none of the surfaces that were tried in place of the faces around them is without "
                       "intersections{}",
                       left_some ? "; faces at vertices that lie on others were left as they are" : ""));
  }
  if (!same_surface(before, mesh_topology(found->whole)))
    refuse(piece, "a surface without them would not have the piece's genus and boundaries");
  const TriangleMesh gone = faces_lacking(found->part, found->found),
                     put = faces_lacking(found->found, found->part);
  const double share = area(gone) / area(piece.mesh);
  if (share > most_area)
    refuse(piece,
           fmt::format(
               "a surface without them would replace {:.0f}% of the piece: that is more than a small fault",
               100.0 * share));
  const double to_original = largest_distance(put, found->part);
  const double diagonal = bounding_box(piece.mesh.points).diagonal();
  // Where what was pulled through is cut off, new faces lie as far from the rest as they are long.
  if (to_original > std::max(farthest * diagonal, edge_lengths(put).max))
    refuse(piece, fmt::format("a surface without them would lie up to {:.3g} off the mesh, which is "
                              "{:.3g} from corner to corner",
                              to_original, diagonal));
  ++all.components;
  all.crossings += piece.pairs.size();
  all.replaced += gone.triangles.size();
  all.to_original = std::max(all.to_original, to_original);
  all.from_original = std::max(all.from_original, largest_distance(gone, found->found));
  return std::move(found->whole);
}

}  // namespace

Untangled untangle(const TriangleMesh& mesh) {
  if (std::string_view(cgal_version()).empty()) refuse_without_cgal();
  const MeshTopology topology = mesh_topology(mesh);
  const auto component_of = [&](FaceIndex face) { return topology.component_of_face[face]; };
  const SelfIntersections all = crossings(mesh, coincident_points(mesh.points).representative);
  std::vector<std::vector<FaceIndex>> faces(topology.components);
  std::vector<bool> no_area(topology.components, false);
  std::vector<FaceIndex> number(mesh.triangles.size());  // within the component
  for (FaceIndex face = 0; face < mesh.triangles.size(); ++face) {
    std::vector<FaceIndex>& own = faces[component_of(face)];
    number[face] = static_cast<FaceIndex>(own.size());
    own.push_back(face);
    if (has_no_area(mesh.points, mesh.triangles[face])) no_area[component_of(face)] = true;
  }
  std::vector<std::vector<std::array<FaceIndex, 2>>> pairs(topology.components);
  for (const auto& [first, second] : all.pairs)
    if (component_of(first) == component_of(second))
      pairs[component_of(first)].push_back({number[first], number[second]});
  Untangled untangled;
  for (std::size_t c = 0; c < topology.components; ++c) {
    CrossingPiece piece{part_of(mesh, faces[c]), std::move(pairs[c]), all.complete};
    const bool crosses = !piece.pairs.empty() && !no_area[c];
    append(untangled.mesh, crosses ? mended(piece, untangled) : piece.mesh);
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
