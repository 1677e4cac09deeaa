// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>

#include "nanocarbon/core/quality.h"
#include "nanocarbon/minimisation/cell_minimum.h"

namespace nanocarbon::building {

//! Stiff enough that bond switches feel within their reach what bends the sheet away from the surface:
//! (1.4 eV, graphene's bending rigidity, over the tether for each area)^(1/4) is 3 Angstrom. eV/Angstrom^2.
inline constexpr double default_tether = 0.05;
//! Where the surface's size is meant: a narrow tube's bending presses it outwards by 0.01 eV/Angstrom an
//! atom.
inline constexpr double default_tether_of_size = 0.2;

struct AnnealOptions {
  Quality quality = Quality::good;
  double tether = default_tether;  //!< to the surface while annealing, eV/Angstrom^2
  double force_tolerance = 1e-3;   //!< eV/Angstrom, of the last minimisation
  std::uint64_t seed = 1;
  unsigned threads = 1;
  //! Keep the surface's size. Otherwise, as the number of atoms is what is asked for, it becomes what fits
  //! best.
  bool keep_size = false;
  //! Strains of a periodic cell that the last minimisation frees.
  minimisation::CellRelaxation relax_cell = minimisation::CellRelaxation::none;
  long largest_ring = 7;  //!< atoms in a ring that annealing makes
  //! Called now and then with what is being done and how much of it, 0 to 1.
  std::function<void(std::string_view stage, double share)> progress = {};
};

}  // namespace nanocarbon::building
