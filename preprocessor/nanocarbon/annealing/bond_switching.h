// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "nanocarbon/annealing/switching_patch.h"

namespace nanocarbon::annealing {

struct BondSwitchingOptions {
  double hot = 0.75;   //!< k T of the first block, eV
  double cold = 0.22;  //!< k T of the last block, eV
  int blocks = 30;
  double trials_per_defect = 100;  //!< in each block, for each ring that is no hexagon
  double climb_share = 0.35;       //!< of trials that add or remove two atoms
  double tether = 0.05;            //!< eV/Angstrom^2
  double count_penalty = -1;       //!< eV for each (atoms - target)^2; below zero: by size
  std::size_t target_atoms = 0;    //!< 0: as many as at the start
  long largest_ring = 7;           //!< atoms in a ring; 8 where all of the surface is a saddle
  //! If any: only defects within some bonds of these atoms are tried.
  std::vector<AtomIndex> around = {};
  //! eV, of what a block has come to, which the best block is chosen by in place of its energy under the tether; may be
  //! empty. Not asked for blocks that have far more of that than another.
  std::function<double(const SwitchingState& state)> judged = {};
  std::uint64_t seed = 1;
  unsigned threads = 1;
  //! Called many times a second with the share of the trials that are done; may throw, to end it; may be empty.
  std::function<void(double share)> progress = {};
};

struct BondSwitchingResult {
  double energy_before = 0;  //!< eV for each atom, with tether
  double energy = 0;         //!< eV for each atom, with tether, of the best block, which is kept
  std::size_t trials = 0;    //!< drawn, those known to be refused included
  std::size_t accepted = 0;
  std::size_t defects = 0;
};

//! \brief Anneals the defects of a carbon network by Stone-Wales switches and dislocation climb.
//! \details Monte Carlo with local relaxation on the fixed-bond REBO2 energy; each block ends with a
//! relaxation of the whole. Trials run in batches on one state and are committed in order where they do not
//! overlap, so the outcome does not depend on the number of threads. Rings keep 5 to 7 (or 8) atoms (others only
//! get better); boundaries stay as they are.
//! \param state compact; on return compact and relaxed
BondSwitchingResult anneal_bonds(SwitchingState& state, const TetherSurface& surface,
                                 const BondSwitchingOptions& options);

//! Relaxes all positions of a state on its energy and renews planes and contacts.
//! \return eV, with tether
double relax_state(SwitchingState& state, const TetherSurface& surface, int max_iterations,
                   double force_tolerance);

}  // namespace nanocarbon::annealing
