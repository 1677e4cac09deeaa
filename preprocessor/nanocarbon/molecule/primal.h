#pragma once

#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon {

//! \brief The triangulation that a molecule is the dual of: a vertex for each ring, a triangle for each atom.
//! \details A vertex lies at the mean of its ring's atoms; triangles are wound as the rings are. Atoms at a
//! border lie in fewer than three rings and have no triangle, so a molecule with a border gives a
//! triangulation that ends a little inside of it.
//! \pre the molecule's rings are known and no periodic boundary runs through them
//! \throw UserError (unsuitable) where an atom lies in more than three rings
TriangleMesh primal(const Molecule& molecule);

}  // namespace nanocarbon
