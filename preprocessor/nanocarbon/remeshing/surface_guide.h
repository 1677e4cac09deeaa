#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "nanocarbon/mesh/nearest_point.h"
#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/remeshing/corner_table.h"

namespace nanocarbon {

//! A place on the surface: a triangle of the guide and barycentric weights of its corners.
struct Foot {
  Vec3 point = Vec3::Zero();
  std::array<double, 3> weights = {1, 0, 0};
  std::uint32_t triangle = 0;
};

//! A place on the border: a border half-edge of the guide and the point on it.
struct BorderFoot {
  Vec3 point = Vec3::Zero();
  HalfEdge edge = no_half_edge;
};

//! \brief What keeps moving points on the surface: feet of perpendiculars and normals smoothed at a chosen
//! length. \details Holds a copy of the surface whose long triangles are split (the shape is the same) so
//! that normals vary on the scale of the points' spacing. Lengths in the unit of the surface.
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
  BorderFoot follow_border(const Vec3& p, HalfEdge edge) const;
  //! Unit normal, interpolated.
  Vec3 normal(const Foot& foot) const;
  Vec3 border_normal(const BorderFoot& foot) const;
  Vec3 border_direction(const BorderFoot& foot) const;

  const TriangleMesh& mesh() const { return mesh_; }
  const CornerTable& table() const { return table_; }

 private:
  Foot closest_on(const Vec3& p, std::uint32_t triangle) const;
  const Vec3& at(HalfEdge h) const { return mesh_.points[table_.origin(h)]; }

  TriangleMesh mesh_;
  CornerTable table_;
  std::vector<Vec3> exact_normals_;
  std::vector<Vec3> normals_;
  std::vector<HalfEdge> border_in_;  //!< per vertex: the border half-edge that ends there
  double mean_edge_ = 0;
  std::unique_ptr<NearestPoint> tree_;
};

}  // namespace nanocarbon
