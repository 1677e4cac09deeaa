// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::shapes {

//! \brief The Goldberg-Coxeter subdivision of a closed triangle mesh: each triangle becomes h^2 + h k + k^2.
//! \details Each triangle is cut out of the triangular lattice along the vector (h, k); small triangles that
//! cross an edge are joined across it. Vertices of the base keep their valence, all new ones have valence 6.
//! Vertices come first in the order of the base, then as they are met. Points lie on the flat triangles of
//! the base. Exact: integers only until the points are placed. H. S. M. Coxeter, "Virus macromolecules and
//! geodesic domes" (1971).
//! \param base closed, 2-manifold and oriented, perhaps in a cell; all its triangles should be equilateral for an even
//! subdivision
//! \pre h >= 0, k >= 0, not both 0. (k, h) is the mirror image of (h, k).
TriangleMesh goldberg_coxeter(const TriangleMesh& base, int h, int k);

}  // namespace nanocarbon::shapes
