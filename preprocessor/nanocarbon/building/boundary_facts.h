// SPDX-License-Identifier: GPL-2.0-or-later
// What a molecule's boundary is made of and what it costs.
#pragma once

#include <cstddef>
#include <string_view>

#include "nanocarbon/molecule/boundary_units.h"
#include "nanocarbon/molecule/molecule.h"
#include "nanocarbon/potential/potential.h"

namespace nanocarbon::building {

//! What becomes of the carbon atoms at a boundary, which have two neighbours.
enum class Boundary {
  hydrogen,  //!< each is bonded to a hydrogen atom
  bare       //!< a bond dangles
};
//! The name on the command line and in reports.
std::string_view name(Boundary boundary);

struct BoundaryFacts {
  molecule::BoundaryUnits units;
  std::size_t hydrogens = 0;
  //! Of the atoms within two bonds of an open one above as many of graphene, hydrogen counted as in benzene, eV:
  //! what bending they share is part of it.
  double energy = 0;
};

//! \param molecule with rings, at rest under the potential
BoundaryFacts boundary_facts(const Molecule& molecule, potential::Potential& potential);

}  // namespace nanocarbon::building
