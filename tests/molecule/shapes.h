// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::test {

//! The icosahedron, vertices on the unit sphere, wound counter-clockwise seen from outside.
TriangleMesh icosahedron();

//! Each triangle cut into three at its centroid and the old edges flipped, vertices put on the unit sphere:
//! three times the triangles. The dual of the icosahedron after one such step is C60, after three C540.
TriangleMesh sqrt3_subdivided_sphere(const TriangleMesh& sphere);

//! A triangulated torus or a tube of radius `tube` around a circle of radius `circle`: around x along quads,
//! each cut in two.
TriangleMesh torus(int around, int along, double circle, double tube);

//! An open cylinder along z: `around` points in each of `rows` + 1 staggered rows, edges all of unit length
//! in the plane.
TriangleMesh cylinder(int around, int rows);

//! A flat sheet of unit triangles in the xy plane: columns x rows rhombi, each of two triangles.
TriangleMesh sheet(int columns, int rows);

//! The mesh without the triangles that have one of the given vertices.
TriangleMesh without_vertices(const TriangleMesh& mesh, const std::vector<VertexIndex>& vertices);

//! The mesh scaled so that the mean bond of its dual is 1.42 Angstrom.
TriangleMesh scaled_to_carbon(TriangleMesh mesh);

}  // namespace nanocarbon::test
