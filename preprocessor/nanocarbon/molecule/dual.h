// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::molecule {

//! \brief The molecule that is the dual of a triangulation (thesis section 4.7, Algorithm 7).
//! \details Carbon atom i is the centroid of triangle i; every edge between two triangles is a bond, every
//! inner vertex a ring. Rings come in the order of their vertices and run counter-clockwise seen from
//! outside, starting at their lowest atom. Vertices on a boundary have no ring, their atoms have fewer than
//! three bonds. In a cell bonds lead to the nearest images. On a surface that cannot be oriented a ring runs
//! as its lowest triangle is wound.
//! \param triangulation a 2-manifold, with or without boundary; Angstrom
//! \throw UserError (unsuitable) naming the edge or vertex where the triangulation is no 2-manifold, or a
//! triangle whose vertices are not three different points of the mesh
Molecule dual(const TriangleMesh& triangulation);

}  // namespace nanocarbon::molecule
