// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/diagnosis.h"

#include <algorithm>

namespace nanocarbon::mesh {

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
    case MeshProblem::components_intersect:
      return "pieces_intersect";
    case MeshProblem::images_intersect:
      return "images_intersect";
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

}  // namespace nanocarbon::mesh
