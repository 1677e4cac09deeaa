// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "nanocarbon/core/cell.h"
#include "nanocarbon/mesh/diagnosis.h"
#include "nanocarbon/mesh/grids/field_request.h"
#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! What a user asks for of the space that a mesh is in.
struct CellRequest {
  std::optional<std::array<bool, 3>>
      periodic;                          //!< directions; none of them: free space. Nothing: as the file says
  std::optional<Mat3> vectors;           //!< edges as columns, mesh units; nothing: the file's, or the box
  std::array<int, 3> cells = {1, 1, 1};  //!< that many as one
  double match = 1e-3;  //!< mean edges within which boundary vertices are images of each other
};

//! What is asked of a field that is in a cell: periodic where that is asked to be.
FieldRequest field_in_cell(FieldRequest field, const CellRequest& request);

//! \brief The cell that a mesh is in: that of the request, of the file, or around the mesh.
//! \details A cell that is given begins at the mesh's low corner, in the cell's coordinates.
//! \return nothing for free space
//! \throw UserError (usage) for a cell that is flat, left-handed or very skewed, or where the mesh has no extent
//! in a periodic direction
std::optional<Cell> requested_cell(const CellRequest& request, const PolygonSoup& soup);

//! Takes findings out of a diagnosis that are of the cut at the cell's faces and not of the surface: parts that
//! touch each other there. (Intersections are found in the cell: find_intersections_in_cell().)
void drop_findings_of_the_cut(MeshDiagnosis& diagnosis);

//! \brief A mesh in free space as one in its cell: sewn and repeated.
//! \param notes what was done is added
//! \throw UserError (unsuitable) as sew_in_cell()
TriangleMesh in_cell(const TriangleMesh& mesh, const Cell& cell, const CellRequest& request,
                     std::vector<std::string>& notes);

}  // namespace nanocarbon::mesh
