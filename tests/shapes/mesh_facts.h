// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <map>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::test {

//! What can be counted and measured on a triangle mesh, found in the plainest way.
struct MeshFacts {
  bool manifold = false;  //!< edges in one or two triangles, oppositely wound; one fan around each vertex
  std::size_t boundaries = 0;  //!< boundary loops
  std::size_t components = 0;
  long euler_characteristic = 0;
  double volume = 0.0;  //!< signed, of the part below the surface; positive when wound outward
  double area = 0.0;
  double mean_edge = 0.0;
  double shortest_edge = 0.0;
  double longest_edge = 0.0;
  double smallest_angle = 0.0;  //!< degrees
  double sharpest_fold = 0.0;   //!< largest angle between the normals of neighbouring triangles, degrees
  std::size_t largest_valence = 0;
};

MeshFacts mesh_facts(const TriangleMesh& mesh);

}  // namespace nanocarbon::test
