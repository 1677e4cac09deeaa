// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "nanocarbon/annealing/annealing_level.h"
#include "nanocarbon/building/annealed_options.h"
#include "nanocarbon/building/annealing_record.h"
#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/molecule/molecule.h"
#include "nanocarbon/potential/potential.h"

namespace nanocarbon::building {

//! A molecule at a minimum of the full potential.
struct FinalMinimum {
  Molecule molecule;                    //!< with rings, where it fits the surface best; hydrogen comes last
  annealing::TrivalentNetwork network;  //!< of the molecule, with what it has on boundaries
  RestingState rest;
  double growth = 1;                    //!< the surface times this fits the molecule
  Mat3 deformation = Mat3::Identity();  //!< of the cell, and of the surface in it
  Mat3 stress = Mat3::Zero();           //!< of the cell, eV/Angstrom^3; negative under pressure
  std::size_t accepted = 0;             //!< bond switches made, those of the level included
};

//! \brief Lets a molecule go and minimises its energy by the full potential; then moves it to where it fits the
//! surface best.
//! \details Where the potential would see other bonds than the molecule's, the place is mended first by
//! switching bonds, twice at most. Hydrogen is added at the boundary where the options want it. In a cell the strains that the options name are freed.
//! \param level relaxed under the tether
//! \param surface Angstrom, on which the level is
//! \param atoms wanted
FinalMinimum final_minimum(annealing::AnnealingLevel level, const TriangleMesh& surface, std::size_t atoms,
                           potential::Potential& potential, const AnnealOptions& options);

//! \brief A molecule's state at rest, measured.
//! \param energy eV, of the whole molecule
RestingState resting_state(const Molecule& molecule, const potential::Potential& potential, double energy,
                           double max_force, bool intact);

}  // namespace nanocarbon::building
