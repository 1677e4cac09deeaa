// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/mesh/diagnosis.h"
#include "nanocarbon/mesh/polygon_soup.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! Measures a mesh and finds everything that is wrong with it. O(n log n) in faces.
MeshDiagnosis diagnose(const PolygonSoup& soup);

//! \brief Adds where the faces of a mesh in its periodic cell intersect, with each other or with images of others.
//! \details Places are points in the cell, without numbers: the mesh is not as it was read.
void find_intersections_in_cell(const TriangleMesh& mesh, MeshDiagnosis& diagnosis);

}  // namespace nanocarbon::mesh
