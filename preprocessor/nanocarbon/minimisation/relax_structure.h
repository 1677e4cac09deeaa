// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>

#include "nanocarbon/minimisation/minimise_molecule.h"
#include "nanocarbon/molecule/molecule.h"
#include "nanocarbon/potential/potential.h"

namespace nanocarbon::minimisation {

//! What may change its length while a structure is relaxed.
struct FreeEdges {
  std::array<bool, 3> free = {false, false, false};  //!< edges of the cell
  bool alike_across = false;                         //!< the first two by the same factor
};

//! \brief Minimises the energy of a structure, in free space or in a cell, over positions and free edges.
//! \details L-BFGS over all of them together: positions scale with the edges, whose logarithms are variables.
//! At the end forces and the stress along free edges are zero, up to the tolerance.
//! \pre free edges are those of a cell whose edges lie along x, y and z, and are periodic
//! \return intact is not determined
MinimisationResult relax_structure(Molecule& structure, potential::Potential& potential,
                                   const FreeEdges& edges = {}, const MinimisationOptions& options = {});

}  // namespace nanocarbon::minimisation
