// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::thesis {

//! \brief M_p: a copy of a mesh that points are projected to (section 4.5, Algorithm 6).
//! \details A point goes to the nearest point of the triangles around the nearest vertices. "Orthogonal
//! projection" to a triangle is the nearest point of the triangle: a foot outside of the triangle would not
//! be a point of the surface. That is not always the nearest point of the whole surface: see
//! mesh/nearest_point.h for one that is.
class ProjectionMesh {
 public:
  explicit ProjectionMesh(TriangleMesh mesh);
  ~ProjectionMesh();
  ProjectionMesh(ProjectionMesh&&) noexcept;
  ProjectionMesh& operator=(ProjectionMesh&&) noexcept;

  //! \param nearest_vertices 5 as the thesis, 1 as the methods before it
  Vec3 project(const Vec3& point, unsigned nearest_vertices) const;

 private:
  struct Search;
  std::unique_ptr<Search> search_;
};

struct ProjectionTotals {
  double mean_move = 0.0;  //!< Angstrom
  double max_move = 0.0;   //!< Angstrom
};

//! Projects every point, each by itself; threads do not change the result.
ProjectionTotals project_points(std::vector<Vec3>& points, const ProjectionMesh& surface,
                                unsigned nearest_vertices, unsigned threads = 1);

}  // namespace nanocarbon::thesis
