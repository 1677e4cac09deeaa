// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/annealing/fixed_bond_rebo2.h"
#include "nanocarbon/annealing/surface_tether.h"
#include "nanocarbon/core/stage_clock.h"
#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::annealing {

struct DualRelaxationOptions {
  double tether = 0.05;              //!< to the surface's tangent planes, eV/Angstrom^2
  int max_iterations = 400;          //!< of each stage
  double force_tolerance = 0.02;     //!< eV/Angstrom, of the REBO2 stage
  unsigned unknotting_attempts = 1;  //!< where bonds end up above 1.7 Angstrom or other pairs below 2.0
  bool free_mean = true;             //!< of the heights above the surface, see add_tether()
  bool springs_first = true;         //!< not needed where positions have been relaxed before
  Running running = {};
};

struct DualRelaxationResult {
  double energy = 0;            //!< fixed-bond REBO2 without tether and steric terms, eV
  double max_force = 0;         //!< eV/Angstrom, with all terms
  double shortest_bond = 0;     //!< Angstrom
  double longest_bond = 0;      //!< Angstrom
  double closest_unbonded = 0;  //!< Angstrom, see geometry_check.h
  std::size_t unknotted = 0;    //!< atoms in the last place that had to be unknotted
  double mean_distance = 0;     //!< of the atoms to the surface, Angstrom
};

//! \brief From the raw dual of a triangulation to bonds in a narrow window around 1.42 Angstrom.
//! \details Springs along bonds and angles first, then REBO2 on the fixed bond graph with a steric term; no
//! bond is ever broken or formed, and atoms slide along the surface freely.
//! \param molecule positions in Angstrom, rough bonds of any length; at most three bonds for each atom
DualRelaxationResult relax_dual(Molecule& molecule, const TetherSurface& surface,
                                const DualRelaxationOptions& options = {});

//! The same for bare positions on a bond graph, as annealing keeps them.
DualRelaxationResult relax_network(const FixedBondGraph& graph, std::vector<Vec3>& positions,
                                   const TetherSurface& surface, const DualRelaxationOptions& options = {});

}  // namespace nanocarbon::annealing
