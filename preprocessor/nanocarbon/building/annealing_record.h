// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "nanocarbon/core/vec3.h"

namespace nanocarbon::building {

//! A molecule where a minimisation of the full potential left it.
struct RestingState {
  double energy = 0;            //!< eV for each atom
  double above_graphene = 0;    //!< eV for each carbon atom, hydrogen counted as in benzene (potential.h)
  double max_force = 0;         //!< eV/Angstrom
  bool intact = false;          //!< the potential sees exactly the molecule's bonds
  double closest_unbonded = 0;  //!< of carbon and carbon, Angstrom, at most 2.2 (annealing/geometry_check.h)
};

//! What the annealed recipe did.
struct AnnealingRecord {
  double unannealed_energy = 0;         //!< eV for each atom, of dual relaxation alone
  int refinements = 0;                  //!< times that the triangulation was cut in four
  std::size_t accepted = 0;             //!< bond switches made
  Mat3 deformation = Mat3::Identity();  //!< of the cell by the last minimisation, the surface's too
  Mat3 stress = Mat3::Zero();           //!< of the cell, eV/Angstrom^3; negative under pressure
};

}  // namespace nanocarbon::building
