// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>

#include "nanocarbon/annealing/annealing_level.h"
#include "nanocarbon/core/quality.h"
#include "nanocarbon/core/stage_clock.h"
#include "nanocarbon/minimisation/cell_minimum.h"

namespace nanocarbon::building {

//! Stiff enough that a bond switch, within its reach, feels what bends the sheet away from the surface: (graphene's
//! bending rigidity of 1.4 eV over the tether per area)^(1/4) is 3 Angstrom. eV/Angstrom^2.
inline constexpr double default_tether = 0.05;
//! If the surface's size is prescribed: the bending of a narrow tube presses its atoms outwards with 0.01 eV/Angstrom
//! each.
inline constexpr double default_tether_of_size = 0.2;

//! Where potentials attract unbonded atoms, as AIREBO does, sheets lie 3.4 Angstrom apart; where pentagons of two
//! sheets meet they come nearer. From this on the fixed bonds of annealing keep them apart, so that pentagons are
//! annealed to where they do not press on each other. Angstrom.
inline constexpr double steric_reach_of_layers = 3.2;

struct AnnealOptions {
  Quality quality = Quality::good;
  double tether = default_tether;  //!< to the surface while annealing, eV/Angstrom^2
  double force_tolerance = 1e-3;   //!< eV/Angstrom, of the final minimisation
  std::uint64_t seed = 1;
  Running running = {};
  //! Keep the surface's size. Otherwise the number of atoms is prescribed, and the size becomes what fits them best.
  bool keep_size = false;
  //! Strains of a periodic cell that the final minimisation may change.
  minimisation::CellRelaxation relax_cell = minimisation::CellRelaxation::none;
  bool hydrogen = true;  //!< at the boundary
  //! Below which unbonded atoms repel each other while annealing, Angstrom.
  double steric_reach = annealing::default_steric_reach;
  long largest_ring = 7;  //!< atoms in a ring that annealing makes
  //! Called now and then with what is being done and how much of it, 0 to 1.
  std::function<void(std::string_view stage, double share)> progress = {};
};

//! What acts on a level beside its bonds, by these options.
inline annealing::LevelOptions level_options(const AnnealOptions& options) {
  return {.tether = options.tether,
          .free_mean = !options.keep_size,
          .steric_reach = options.steric_reach,
          .running = options.running};
}

}  // namespace nanocarbon::building
