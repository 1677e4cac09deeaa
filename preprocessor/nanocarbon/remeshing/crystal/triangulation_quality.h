// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::crystal {

//! How good a triangulation is as the start of a carbon molecule. Ratios are to the mean of their kind.
struct TriangulationQuality {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t defects = 0;  //!< inner vertices whose valence is not 6
  std::size_t bad = 0;      //!< inner vertices whose valence is outside 5..7
  std::size_t charge = 0;   //!< sum of |valence - 6| over inner vertices
  double edge_mean = 0;     //!< in the mesh's unit
  double edge_cv = 0;       //!< standard deviation of edge lengths over their mean
  double bond_cv = 0;       //!< the same of the edges of the dual of centroids
  double bond_min = 0;
  double bond_max = 0;
  //! Triangles turned by more than 120 degrees against the surface at the point nearest to their centroid.
  //! Those across a rim thinner than an edge rightly stand square to both sides.
  std::size_t folds = 0;
  double distance_mean = 0;  //!< from centroids and vertices to the surface, in mean edges
  double distance_max = 0;
};

//! Measures a triangulation against the surface that it stands for. Linear in faces but for the search tree.
TriangulationQuality measure_triangulation(const TriangleMesh& triangulation, const TriangleMesh& surface);

}  // namespace nanocarbon::crystal
