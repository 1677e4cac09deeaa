// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/mesh/triangle_tree.h"

namespace nanocarbon::mesh {

//! A point of a surface, and how far it was from where the search began.
struct SurfacePoint {
  Vec3 point;              //!< mesh units; in a cell the image beside where the search began
  std::uint32_t triangle;  //!< one that holds the point (of several, one of them)
  double distance;         //!< mesh units
};

//! \brief The point of a triangle nearest to p, as weights of its corners (Ericson, Real-Time Collision
//! Detection, 5.1.5).
//! \details Triangles without area are handled as the segment or point that they are.
std::array<double, 3> nearest_weights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

//! The point itself; exactly a corner where that is nearest.
Vec3 nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

//! \brief Finds the exact nearest point on the triangles of a mesh, in a cell on all their images.
//! \details Keeps what it needs of the mesh. Queries are const and may run in several threads at once.
class NearestPoint {
 public:
  //! O(n log n).
  //! \pre the mesh has a triangle
  explicit NearestPoint(const TriangleMesh& mesh);

  SurfacePoint nearest(const Vec3& query) const;
  //! The same, beginning with a triangle that is known to be near.
  SurfacePoint nearest(const Vec3& query, std::uint32_t triangle_nearby) const;
  //! For every point. Points that follow each other should be near each other.
  std::vector<SurfacePoint> nearest(std::span<const Vec3> queries) const;

 private:
  using Corners = std::array<Vec3, 3>;

  void search_images(const Vec3& query, SurfacePoint& best, double& best_squared) const;
  void search(const Vec3& query, SurfacePoint& best, double& best_squared) const;

  Space space_;
  TriangleTree tree_;
  std::vector<Corners> corners_;         // in the order of the tree's leaves
  std::vector<std::uint32_t> place_of_;  // of a triangle in that order
};

}  // namespace nanocarbon::mesh
