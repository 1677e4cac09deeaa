// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/describe.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace nanocarbon::mesh {
namespace {

struct Words {
  const char* one;
  const char* many;
  const char* remedy;
};

Words words_for(MeshProblem problem) {
  switch (problem) {
    case MeshProblem::no_faces:
      return {"the mesh has no faces", "", "give a mesh with faces; point clouds need to be meshed first"};
    case MeshProblem::too_many_corners:
      return {"face has more than 10000 corners", "faces have more than 10000 corners",
              "triangulate the mesh"};
    case MeshProblem::repeated_vertex:
      return {"face passes through a vertex twice", "faces pass through a vertex twice",
              "remove or divide these faces"};
    case MeshProblem::duplicate_face:
      return {"face lies on another one with the same vertices",
              "faces lie on other ones with the same vertices", "remove one of each pair"};
    case MeshProblem::non_manifold_edge:
      return {"edge has more than two faces", "edges have more than two faces",
              "separate the parts that meet there, or remove inner faces"};
    case MeshProblem::non_manifold_vertex:
      return {"vertex joins parts of the surface at a single point",
              "vertices join parts of the surface at single points", "give each part a vertex of its own"};
    case MeshProblem::not_orientable:
      return {"piece is not orientable: it has no two sides",
              "pieces are not orientable: they have no two sides", "cut it open or use another surface"};
    case MeshProblem::no_area:
      return {"face has no area: its vertices lie on a line",
              "faces have no area: their vertices lie on a line", "remove slivers, or remesh the surface"};
    case MeshProblem::components_intersect:
      return {"pair of faces of different pieces intersects", "pairs of faces of different pieces intersect",
              "unite the pieces (boolean union) or move them apart"};
    case MeshProblem::images_intersect:
      return {"pair of faces of a piece and a periodic image of the piece intersects",
              "pairs of faces of a piece and a periodic image of the piece intersect",
              "the piece is too large for its cell, or the cell is not the right one: give a larger one "
              "(--cell)"};
    case MeshProblem::inconsistent_winding:
      return {"edge has its two faces wound against each other",
              "edges have their two faces wound against each other",
              "the faces are turned when the mesh is used"};
    case MeshProblem::inside_out:
      return {"the mesh is inside-out: its faces enclose a negative volume", "",
              "it is turned when it is used"};
    case MeshProblem::unused_vertex:
      return {"vertex belongs to no face", "vertices belong to no face",
              "they are dropped when the mesh is used"};
    case MeshProblem::self_intersection:
      return {"pair of faces intersects", "pairs of faces intersect",
              "atoms may come too close there (where --untangle mends it, inspect says so)"};
    case MeshProblem::search_given_up:
      return {"the search for intersections was abandoned: too many faces overlap", "",
              "look at the mesh in a viewer"};
    case MeshProblem::duplicate_vertex:
      break;
  }
  return {"vertex lies exactly on another one", "vertices lie exactly on others",
          "the surface touches itself there, and atoms may come too close"};
}

}  // namespace

std::string describe(const MeshFinding& finding) {
  const Words words = words_for(finding.problem);
  const bool anywhere = *words.many == '\0' || finding.places.empty();
  if (anywhere) return fmt::format("{}; {}", words.one, words.remedy);
  const MeshPlace& place = finding.places[0];
  std::string where =
      fmt::format("at ({:.6g}, {:.6g}, {:.6g})", place.point.x(), place.point.y(), place.point.z());
  const char* first = finding.count == 1 ? "" : "first ";
  if (place.vertices.empty())  // of a mesh that was changed since it was read
    return fmt::format("{} {} ({}{} in the cell); {}", finding.count,
                       finding.count == 1 ? words.one : words.many, first, where, words.remedy);
  if (!place.faces.empty())
    where += fmt::format(", face{} {}", place.faces.size() > 1 ? "s" : "", fmt::join(place.faces, " and "));
  where +=
      fmt::format(", vert{} {}", place.vertices.size() > 1 ? "ices" : "ex", fmt::join(place.vertices, ", "));
  return fmt::format("{} {} ({}{}; numbers from 0); {}", finding.count,
                     finding.count == 1 ? words.one : words.many, first, where, words.remedy);
}

}  // namespace nanocarbon::mesh
