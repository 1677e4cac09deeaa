// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "nanocarbon/annealing/bond_switching.h"

namespace nanocarbon::annealing {

//! An intermediate molecule with a given number of atoms, on the surface scaled to fit that number.
struct AnnealingLevel {
  SwitchingState state;
  double unannealed = 0;     //!< eV for each atom, without tether, before any bond was switched
  double mean_distance = 0;  //!< of the atoms to the surface, Angstrom
  std::size_t accepted = 0;  //!< bond switches
  bool sound = false;        //!< REBO2 would see the intended bonds; as of relax_level()
};

//! What acts on the atoms of a level beside the bonds.
struct LevelOptions {
  double tether = 0;                           //!< to the surface, eV/Angstrom^2
  bool free_mean = true;                       //!< of the heights above the surface, see add_tether()
  double steric_reach = default_steric_reach;  //!< below which unbonded atoms repel each other, Angstrom
  Running running = {};
};

//! The dual of a triangulation as it is, but for triangles that hang on by one side, which are left out; with
//! hydrogen at its boundary. Nothing if parts are so thin for its faces that it pinches them.
std::optional<AnnealingLevel> level_on(const TriangleMesh& triangulation, const LevelOptions& options);

//! Whether REBO2 would see the intended bonds at the present positions, with a margin for relaxation without
//! the tether.
bool holds(const AnnealingLevel& level);

//! Relaxes under the tether.
//! \param raw unknots first, and begins with springs
void relax_level(AnnealingLevel& level, const TetherSurface& surface, bool raw = true);

//! Switches bonds; options.tether is the level's.
void anneal_level(AnnealingLevel& level, const TetherSurface& surface, BondSwitchingOptions options);

//! Switches bonds until REBO2 would see the intended ones, a little at a time and without heat.
//! \param places atoms where it would not, in the end: in large molecules bonds are switched around them only
void mend_level(AnnealingLevel& level, const TetherSurface& surface, BondSwitchingOptions options,
                std::span<const AtomIndex> places);

//! \brief How far the surface reaches beyond the molecule: the distance of its farthest vertex from the
//! molecule's triangulation, Angstrom.
//! \details Atoms of a molecule that has lost a limb all lie on the surface: only this shows it.
//! \pre every vertex of the surface is one of a triangle's
double lost_reach(const AnnealingLevel& level, const TriangleMesh& surface);

}  // namespace nanocarbon::annealing
