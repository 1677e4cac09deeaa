// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <mpi.h>

#include <cstdint>
#include <span>
#include <vector>

#include "bond_topology/local_bonds.h"
#include "bond_topology/surface_watch.h"

namespace nanocarbon {

//! Watched atoms of all ranks on rank 0, and where each rank's are among them. Empty on the other ranks.
struct Gathered {
  WatchedAtoms atoms;
  std::vector<std::size_t> place;  //!< in atoms, of each atom in the order of ranks and of their atoms
  std::vector<int> counts;         //!< of each rank's atoms
};

//! Collective. Bonds are the candidates that are bonded now.
Gathered gather(MPI_Comm world, const RankAtoms& atoms, const CandidateBonds& candidates);

//! \brief Collective: carries rank 0's states back, to each rank for its own watched atoms in their order.
//! \param states used on rank 0 only, in the order of gathered.atoms
std::vector<AtomState> scatter(MPI_Comm world, const Gathered& gathered, std::span<const AtomState> states,
                               std::size_t own);

}  // namespace nanocarbon
