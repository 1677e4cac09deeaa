// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! What can be wrong with a mesh.
enum class MeshProblem {
  // Reasons why a mesh cannot be used, unless repair_surface() can mend them.
  no_faces,
  too_many_corners,
  repeated_vertex,
  duplicate_face,
  non_manifold_edge,
  non_manifold_vertex,
  not_orientable,
  no_area,
  components_intersect,
  images_intersect,
  // Always mended.
  inconsistent_winding,
  inside_out,
  unused_vertex,
  // A mesh can be used in spite of these.
  self_intersection,
  search_given_up,
  duplicate_vertex,
};

enum class Severity { reason, mended, warning };

Severity severity(MeshProblem problem);
//! The problem's name for machines, such as "non_manifold_edge".
const char* name(MeshProblem problem);

//! Where something is wrong. Numbers count from 0.
struct MeshPlace {
  std::vector<VertexIndex> vertices;
  std::vector<FaceIndex> faces;
  Vec3 point = Vec3::Zero();  //!< mesh units
};

//! One thing that is wrong with a mesh, and everywhere it is.
struct MeshFinding {
  MeshProblem problem;
  std::size_t count = 0;
  std::string text;               //!< how many, what is wrong, where first, what to do
  std::vector<MeshPlace> places;  //!< the first ten
};

//! What a mesh is and what is wrong with it.
struct MeshDiagnosis {
  std::size_t points = 0;
  std::size_t faces = 0;
  std::size_t most_corners_of_a_face = 0;
  MeshTopology topology;
  BoundingBox box;
  EdgeLengths edges;
  double area = 0.0;  //!< square mesh units
  std::optional<double>
      volume;  //!< cubic mesh units; only for closed, manifold and consistently wound meshes
  std::vector<MeshFinding> findings;

  //! Whether no finding is a reason against using the mesh.
  bool usable() const;
  const MeshFinding* find(MeshProblem problem) const;
};

}  // namespace nanocarbon::mesh
