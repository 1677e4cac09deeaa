// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! Cells of a grid that fill space. Corners are numbered as VTK and Gmsh do.
enum class VolumeCell { tetrahedron, hexahedron, wedge, pyramid };

//! How many of a cell's points are corners; others, on edges and within, follow them.
std::size_t corners_of(VolumeCell cell);

//! What the cells of a grid, as programs for simulations write it, have for a surface: their faces if there are any,
//! else the boundary of those that fill space. Points are numbered from 0; the numbers have to be in range.
class GridSurface {
 public:
  //! A polygon; fewer than three corners are no face.
  void add_face(std::span<const VertexIndex> corners);
  //! A cell that fills space, by its corners.
  void add_volume(VolumeCell cell, std::span<const VertexIndex> corners);
  void skip_point_or_line() { ++skipped_; }
  //! A cell with points on its edges, of which its corners alone are taken.
  void flatten() { ++flattened_; }

  bool empty() const { return soup_.faces() == 0 && volumes_ == 0; }
  //! The surface on these points, with notes on what was taken. Points that it does not use are dropped where it is
  //! a boundary of cells.
  PolygonSoup on(std::vector<Vec3> points) &&;

 private:
  struct CellFace {
    std::array<VertexIndex, 4> corner;
    unsigned corners;
  };
  void take_boundary();

  PolygonSoup soup_;
  std::vector<CellFace> cell_faces_;
  std::size_t volumes_ = 0, skipped_ = 0, flattened_ = 0;
};

}  // namespace nanocarbon::mesh
