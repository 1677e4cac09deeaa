// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string_view>

#include "nanocarbon/minimisation/minimise_molecule.h"

namespace nanocarbon::minimisation {

//! Which strains of a periodic cell are freed, of those along its periodic edges.
enum class CellRelaxation {
  none,
  isotropic,   //!< one: the cell's size
  uniaxial,    //!< two: that along c, and one across it, of a and b alike
  orthogonal,  //!< one for each direction: a, what of b is square to it, what of c to both
  triclinic    //!< all: size and shape
};
//! The name on the command line and in reports.
std::string_view name(CellRelaxation relaxation);

struct CellMinimum {
  MinimisationResult minimum;
  Mat3 deformation = Mat3::Identity();  //!< of the cell and the positions, symmetric to first order
  Mat3 stress = Mat3::Zero();           //!< at the end, eV/Angstrom^3; negative under pressure
};

//! \brief Minimises the energy over all positions and the freed strains of the cell, if there is one.
//! \details Strains are variables beside the positions (Parrinello and Rahman 1981, without inertia), scaled by
//! 1.4 Angstrom and the root of the number of atoms, so that the force tolerance holds the stress below 1e-5
//! eV/Angstrom^3 (1.6 MPa) for 200 atoms and less for more. In free space this is minimise_molecule().
CellMinimum minimise_in_cell(Molecule& molecule, potential::Potential& potential, CellRelaxation relaxation,
                             const MinimisationOptions& options = {});

}  // namespace nanocarbon::minimisation
