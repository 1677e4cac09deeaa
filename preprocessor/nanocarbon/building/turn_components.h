// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "nanocarbon/core/vec3.h"
#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/topology/connected_components.h"

namespace nanocarbon::building {

//! What turn_components() did.
struct TurnedComponents {
  std::size_t turned = 0;  //!< components that lie otherwise now
  double before = 0;       //!< Lennard-Jones energy between components, eV
  double after = 0;        //!< the same of what is returned; never above
};

//! \brief Turns components that face each other, as the shells of an onion, to where pentagons and rows of atoms
//! meet least.
//! \details The shells of an onion, or tubes within each other, turn nearly freely: where they happen to lie,
//! corners of one may press on those of the next. From the largest one on, which stays, each component is
//! turned about its centre to where it fits those before it: by chance, and the best eight by less and less,
//! wherever that keeps it on the surface: the root mean square distance of its atoms may grow by 0.05
//! Angstrom. What counts is the Lennard-Jones energy of graphite's layers (3.4 Angstrom, 2.84 meV), up to 5
//! Angstrom. Nothing happens where no two components are that near.
//! \param positions Angstrom, in free space
//! \param components of the atoms
//! \param surface Angstrom, on which the atoms are
TurnedComponents turn_components(std::span<Vec3> positions, const topology::Components& components,
                                 const TriangleMesh& surface, std::uint64_t seed);

}  // namespace nanocarbon::building
