// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::molecule {

//! \brief A molecule's surface as a triangle mesh, in its cell if it has one: each ring a fan around its centre.
//! \details Points are the atoms, in their order, then the centres of the rings.
//! \pre rings are known (those of dual, or SurfaceTopology::rings)
TriangleMesh ring_mesh(const Molecule& molecule);

}  // namespace nanocarbon::molecule
