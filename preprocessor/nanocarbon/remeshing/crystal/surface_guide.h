// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "nanocarbon/mesh/nearest_point.h"
#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/remeshing/crystal/corner_table.h"

namespace nanocarbon::crystal {

//! A place on the surface: a triangle of the guide and barycentric weights of its corners. The point is beside
//! the one that it was sought for.
struct Foot {
  Vec3 point = Vec3::Zero();
  std::array<double, 3> weights = {1, 0, 0};
  std::uint32_t triangle = 0;
};

//! A place on the boundary: a boundary half-edge of the guide and the point on it.
struct BoundaryFoot {
  Vec3 point = Vec3::Zero();
  HalfEdgeIndex edge = no_half_edge;
};

//! \brief What keeps moving points on the surface: feet of perpendiculars and normals smoothed at a chosen
//! length.
//! \details Holds a copy of the surface whose long triangles are split (the shape is the same) so that
//! normals vary on the scale of the points' spacing. Lengths in the unit of the surface.
class SurfaceGuide {
 public:
  //! \param spacing no edge of the copy is longer than this
  SurfaceGuide(const TriangleMesh& surface, double spacing);

  //! Averages the normals over about this length; from the exact normals each time it is called.
  void smooth_normals(double length);
  //! The nearest point that is reached from a triangle by walking downhill. Never jumps to another sheet.
  Foot follow(const Vec3& p, std::uint32_t triangle) const;
  //! The nearest point of all, unless the surface there faces away from `facing`; then what follow() finds.
  Foot nearest(const Vec3& p, const Vec3& facing, std::uint32_t triangle) const;
  //! The nearest point of all.
  Foot nearest(const Vec3& p) const;
  BoundaryFoot follow_boundary(const Vec3& p, HalfEdgeIndex edge) const;
  //! Unit normal, interpolated.
  Vec3 normal(const Foot& foot) const;
  Vec3 boundary_normal(const BoundaryFoot& foot) const;
  Vec3 boundary_direction(const BoundaryFoot& foot) const;

  const TriangleMesh& mesh() const { return mesh_; }
  const Space& space() const { return mesh_.space; }
  const CornerTable& table() const { return table_; }

 private:
  Foot closest_on(const Vec3& p, std::uint32_t triangle) const;
  const Vec3& at(HalfEdgeIndex h) const { return mesh_.points[table_.origin(h)]; }

  TriangleMesh mesh_;
  CornerTable table_;
  std::vector<Vec3> exact_normals_;
  std::vector<Vec3> normals_;
  std::vector<HalfEdgeIndex> boundary_in_;  //!< per vertex: the boundary half-edge that ends there
  double mean_edge_ = 0;
  //! Built when the nearest point of all is first asked for, which not every user does; by one thread.
  struct Tree {
    std::once_flag built;
    std::optional<mesh::NearestPoint> search;
  };
  std::unique_ptr<Tree> tree_;
};

}  // namespace nanocarbon::crystal
