// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "nanocarbon/mesh/grids/grid_surface.h"

namespace nanocarbon::mesh {

//! Refuses a file, saying what is wrong; does not return.
using CellRefusal = std::function<void(const std::string& what)>;

//! What a file of VTK has of cells, until its points are known: lists of points, and for each cell where its list ends.
struct VtkCells {
  std::vector<double> points;
  std::vector<double> ends;   //!< without the zero that some versions begin with
  std::vector<double> types;  //!< as VTK numbers them; empty: all are of the same
};

constexpr int vtk_strip = 6, vtk_polygon = 7;

//! \brief Adds cells to a surface: faces, strips of triangles, cells that fill space; points and lines are skipped, and
//! of curved cells the corners are taken.
//! \param first number of the piece's first point among all
//! \param points of the piece
//! \param same_type of all cells where they have no types
void add_vtk_cells(GridSurface& surface, const VtkCells& cells, std::size_t first, std::size_t points,
                   int same_type, const CellRefusal& refuse);

//! Coordinates, three for each point.
std::vector<Vec3> vtk_points(const std::vector<double>& numbers, const CellRefusal& refuse);

}  // namespace nanocarbon::mesh
