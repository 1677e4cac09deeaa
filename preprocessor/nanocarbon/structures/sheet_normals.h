#pragma once

#include <vector>

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon {

//! \brief Unit normals of an sp2 structure from the bonds of its atoms alone.
//! \details An atom's normal is that of the plane through its three neighbours. Signs are carried along the
//! bonds, so that they agree over each piece wherever it has two sides; which side is the outer one is left
//! to chance. Atoms with one or two bonds take the normal of the neighbour met first.
std::vector<Vec3> sheet_normals(const Molecule& molecule);

}  // namespace nanocarbon
