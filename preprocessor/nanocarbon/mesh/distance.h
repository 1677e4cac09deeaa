// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "nanocarbon/mesh/nearest_point.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! Distances from points to a surface. In the unit of the coordinates.
struct DistanceStatistics {
  std::size_t points = 0;
  double mean = 0.0;
  double rms = 0.0;
  double max = 0.0;
  Vec3 farthest = Vec3::Zero();  //!< the point at the largest distance
};

//! Of every point to the nearest point of the surface. O(points log triangles).
DistanceStatistics distances_to_surface(std::span<const Vec3> points, const NearestPoint& surface);

//! \brief Points on a surface, evenly by area: always the same ones for the same mesh and number.
//! \details The area is divided along the mesh's order of triangles, and within a triangle by a
//! low-discrepancy sequence (R2, Roberts 2018).
std::vector<Vec3> sample_by_area(const TriangleMesh& mesh, std::size_t samples);

//! From points of a surface, evenly by area, to the triangles of a mesh: what the mesh lacks of the surface shows here.
//! \param samples how many points; 0 for as many as the larger of the two has triangles
DistanceStatistics distances_of_area(const TriangleMesh& surface, const TriangleMesh& mesh,
                                     std::size_t samples = 0);

//! How far two surfaces are from each other, both ways.
struct SurfaceDistance {
  DistanceStatistics there;  //!< from the points given to the surface
  DistanceStatistics back;   //!< from samples of the surface to the other mesh
  //! The larger of the two maxima: the Hausdorff distance, as far as the samples tell.
  double hausdorff() const { return there.max > back.max ? there.max : back.max; }
};

//! \brief From the vertices of a mesh (a triangulation, or atoms as the vertices of one) to a surface and
//! back.
//! \details Back: the surface's vertices and samples evenly by area, to the triangles of the mesh. Means of
//! the way back are over the samples by area alone; the maximum is over the vertices too.
//! \param mesh, surface both in the same unit, both with a triangle
//! \param samples of the surface's area; 0 for as many as the larger of the two meshes has triangles
SurfaceDistance distance_between(const TriangleMesh& mesh, const TriangleMesh& surface,
                                 std::size_t samples = 0);

}  // namespace nanocarbon::mesh
