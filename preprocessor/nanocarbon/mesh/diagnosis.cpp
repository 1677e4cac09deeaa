#include "nanocarbon/mesh/diagnosis.h"

#include <algorithm>

#include "nanocarbon/mesh/find_problems.h"

namespace nanocarbon {

Severity severity(MeshProblem problem) {
  switch (problem) {
    case MeshProblem::inconsistent_winding:
    case MeshProblem::inside_out:
    case MeshProblem::unused_vertex:
      return Severity::mended;
    case MeshProblem::self_intersection:
    case MeshProblem::search_given_up:
    case MeshProblem::duplicate_vertex:
      return Severity::warning;
    default:
      return Severity::reason;
  }
}

const char* name(MeshProblem problem) {
  switch (problem) {
    case MeshProblem::no_faces:
      return "no_faces";
    case MeshProblem::too_many_corners:
      return "too_many_corners";
    case MeshProblem::repeated_vertex:
      return "repeated_vertex";
    case MeshProblem::duplicate_face:
      return "duplicate_face";
    case MeshProblem::non_manifold_edge:
      return "non_manifold_edge";
    case MeshProblem::non_manifold_vertex:
      return "non_manifold_vertex";
    case MeshProblem::not_orientable:
      return "not_orientable";
    case MeshProblem::no_area:
      return "no_area";
    case MeshProblem::pieces_intersect:
      return "pieces_intersect";
    case MeshProblem::inconsistent_winding:
      return "inconsistent_winding";
    case MeshProblem::inside_out:
      return "inside_out";
    case MeshProblem::unused_vertex:
      return "unused_vertex";
    case MeshProblem::self_intersection:
      return "self_intersection";
    case MeshProblem::search_given_up:
      return "search_given_up";
    case MeshProblem::duplicate_vertex:
      break;
  }
  return "duplicate_vertex";
}

bool MeshDiagnosis::usable() const {
  return std::none_of(findings.begin(), findings.end(),
                      [](const MeshFinding& f) { return severity(f.problem) == Severity::reason; });
}

const MeshFinding* MeshDiagnosis::find(MeshProblem problem) const {
  const auto found = std::find_if(findings.begin(), findings.end(),
                                  [&](const MeshFinding& f) { return f.problem == problem; });
  return found == findings.end() ? nullptr : &*found;
}

MeshDiagnosis diagnose(const PolygonSoup& soup) {
  MeshDiagnosis diagnosis;
  const EdgeTable edges = edge_table(soup);
  diagnosis.points = soup.points.size();
  diagnosis.faces = soup.faces();
  diagnosis.topology = mesh_topology(soup, edges);
  diagnosis.box = bounding_box(soup.points);
  diagnosis.edges = edge_lengths(soup.points, edges);
  for (std::size_t face = 0; face < soup.faces(); ++face) {
    diagnosis.most_corners_of_a_face = std::max(diagnosis.most_corners_of_a_face, soup.face(face).size());
    diagnosis.area += 0.5 * newell_normal(soup.points, soup.face(face)).norm();
  }
  if (diagnosis.topology.closed() && diagnosis.topology.manifold() && diagnosis.topology.consistently_wound())
    diagnosis.volume = signed_volume(soup);
  find_problems(soup, edges, diagnosis);
  return diagnosis;
}

}  // namespace nanocarbon
