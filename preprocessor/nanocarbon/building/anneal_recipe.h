// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "nanocarbon/annealing/trivalent_network.h"
#include "nanocarbon/building/annealed_options.h"
#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/molecule/molecule.h"
#include "nanocarbon/potential/potential.h"

namespace nanocarbon::building {

struct AnnealResult {
  Molecule molecule;                    //!< with rings; at a minimum of the potential
  annealing::TrivalentNetwork network;  //!< of the molecule, with what it has on boundaries
  double unannealed_energy = 0;         //!< eV for each atom, of dual relaxation alone
  double energy = 0;                    //!< eV for each atom
  double max_force = 0;                 //!< eV/Angstrom
  double mean_distance = 0;             //!< of the atoms to the surface, Angstrom
  double growth = 1;                    //!< the surface times this fits the molecule
  Mat3 deformation = Mat3::Identity();  //!< of the cell by the last minimisation, the surface's too
  Mat3 stress = Mat3::Zero();           //!< of the cell, eV/Angstrom^3; negative under pressure
  double shortest_bond = 0;             //!< Angstrom
  double longest_bond = 0;              //!< Angstrom
  double closest_unbonded = 0;          //!< Angstrom, at most 2.2 (geometry_check.h)
  bool intact = false;                  //!< the potential sees exactly the molecule's bonds
  int refinements = 0;                  //!< times the triangulation was cut in four
  std::size_t accepted = 0;             //!< bond switches made
};

//! \brief The default recipe: from a surface to a molecule at a minimum of REBO2.
//!
//! Triangulates the surface and relaxes the dual. Anneals at a sixteenth and a quarter of the atoms and
//! refines step by step, where the shape still shows with so few; anneals at full size, too, where that may
//! be better. Takes the molecule with the least energy once it is let go of those within 1 Angstrom of the
//! surface in the mean; where there is none, at a price for distance (start_choice.h). Then minimises the
//! full potential without a tether; where REBO2 would see other bonds than the molecule's, mends the place
//! first. In the end the molecule is moved to where it fits the surface best.
//!
//! \param surface Angstrom; a sound oriented 2-manifold, with or without boundary
//! \param potential of the last minimisation
//! \param atoms wanted; met within one percent where the surface allows
//! \throw UserError as the triangulator does
AnnealResult anneal(const TriangleMesh& surface, std::size_t atoms, const Triangulator& triangulate,
                    potential::Potential& potential, const AnnealOptions& options);

}  // namespace nanocarbon::building
