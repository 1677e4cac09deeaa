// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "nanocarbon/mesh/triangle_tree.h"
#include "nanocarbon/remeshing/crystal/surface_guide.h"

namespace nanocarbon::features {

//! The triangles of a guide with what a search for opposite sides asks of them.
struct Facets {
  const TriangleMesh& mesh;
  mesh::TriangleTree tree;
  std::vector<Vec3> centres;
  std::vector<Vec3> normals;  //!< smoothed as the guide's are
  std::vector<double> areas;
  std::vector<std::uint32_t> components;  //!< connected component of the surface

  //! \param guide outlives the facets
  explicit Facets(const crystal::SurfaceGuide& guide);
};

struct Opposite {
  Vec3 point = Vec3::Zero();
  double distance = 0;
  bool parallel = false;  //!< it faces the same way: another component inside or outside of this one
};

//! \brief The nearest place that lies along this one, within 45 degrees of its normal.
//! \details Sides of wedges wider than 32 degrees do not lie along each other.
//! \param side 1: outside of the surface, -1: within
//! \param reach the farthest of interest
std::optional<Opposite> opposite(const Facets& facets, std::uint32_t from, double side, double reach);

//! Square of the distance of a point to a box.
double squared_distance(const mesh::BoundingBox& box, const Vec3& p);

}  // namespace nanocarbon::features
