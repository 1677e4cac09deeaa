// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::structures {

//! \brief The icosahedral fullerene of the Goldberg pair (h, k): 20 (h^2 + h k + k^2) atoms, 12 pentagons.
//! \details C20 = (1, 0), C60 = (1, 1), C80 = (2, 0), C140 = (2, 1), C240 = (2, 2), C540 = (3, 3), C960 = (4,
//! 4). The dual of an icosahedron whose faces are cut out of the triangular lattice, its bonds then brought
//! near 1.43 Angstrom by springs. Centred on the origin. (h, k) and (k, h) are mirror images.
//! \throw UserError (usage) for indices below 0, both 0, or more than 10 million atoms
Molecule fullerene(int h, int k);

//! The triangulation that fullerene(h, k) is the dual of, with flat faces and edges of unit length. Same
//! errors.
TriangleMesh icosahedral_triangulation(int h, int k);

}  // namespace nanocarbon::structures
