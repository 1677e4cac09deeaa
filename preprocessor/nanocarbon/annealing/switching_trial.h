// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>
#include <vector>

#include "nanocarbon/annealing/switching_patch.h"
#include "nanocarbon/core/random_stream.h"

namespace nanocarbon::annealing {

//! What a trial is judged by.
struct TrialTerms {
  double temperature = 0.3;  //!< k T, eV
  double count_penalty = 0;  //!< eV for each (atoms - target)^2
  long atoms_above_target = 0;
  double climb_share = 0.35;  //!< of trials that add or remove a pair of atoms
};

//! Outcome of one trial; what to write back if it is accepted.
struct Trial {
  bool accepted = false;
  double energy_change = 0;  //!< eV, of the patch
  std::optional<NetworkEdit> edit;
  std::vector<AtomIndex> moved;  //!< free atoms; added_atoms for those of a split
  std::vector<AtomIndex>
      looked;  //!< all atoms of the patch: the trial holds only while none of them has changed
  std::vector<Vec3> positions;  //!< of the moved
  std::vector<TangentPlane> planes, edges;
};

//! Scratch of one thread.
struct TrialWorkspace {
  SwitchingPatch near, far;
};

//! Draws a switch at one of the defects (rings that are not hexagons), or nothing where ring sizes forbid it.
//! Sizes stay 5 to 7 (or 8), or come nearer to that; the sum of (size - 6)^2 may rise by 4 at most, and by 4 one
//! time in five.
std::optional<NetworkEdit> draw_edit(const TrivalentNetwork& network, std::span<const RingIndex> defects,
                                     double climb_share, RandomStream& random, long largest_ring = 7);

//! The most by which a switch may raise the energy, eV, apart from the price of atoms gained: drawn by the
//! Metropolis rule before anything is relaxed.
double draw_allowance(const NetworkEdit& edit, const TrialTerms& terms, RandomStream& random);

//! \brief Tries a switch on a copy of its surroundings: relaxes them, and accepts what stays within the
//! allowance.
//! \details An atom gained or lost counts with the mean energy of the atoms around: what bending costs there
//! has to be paid for by every atom of the shape, and is no reason to take atoms away from where it is thin.
//! Hopeless relaxations end early, and flips are screened on a small patch. The state is not
//! changed: any number of trials may run at once.
Trial try_edit(const SwitchingState& state, NetworkEdit edit, double allowance, double least_cosine,
               TrialWorkspace& workspace);

}  // namespace nanocarbon::annealing
