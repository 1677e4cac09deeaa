// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::analysis {

//! The triangulation whose dual a molecule is, and which atoms it has triangles for.
struct DualTriangulation {
  TriangleMesh mesh;  //!< Angstrom
  std::vector<AtomIndex>
      atoms;  //!< that each triangle stands for, ascending: carbon that is not in a loose chain
};

//! \brief Turns molecule::dual round: a vertex for each ring, a triangle for each carbon atom.
//! \details Vertices lie in the middle of their rings. Along a boundary, where the ring beside an atom is open, they
//! lie between each two bonds that are missing there, placed so that the middles of the triangles come as near to
//! their atoms as can be. A hole of more atoms than a ring may have and no bond missing becomes a vertex. Hydrogen
//! and carbon that hangs on by one bond have no triangles; components without rings have none. The dual of the result
//! has the same bonds, at places that differ a little. In a periodic cell the mesh is in that cell.
//! \throw UserError (unsuitable) naming the atom where the molecule is no surface, has a boundary that no
//! triangulation has (fewer than three bonds missing, or an atom with a hole on both sides), or a cell narrower than three
//! edges
DualTriangulation dual_triangulation(const Molecule& molecule, std::span<const std::int64_t> ids,
                                     int max_ring = 12);

}  // namespace nanocarbon::analysis
