// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>
#include <vector>

#include "nanocarbon/annealing/fixed_bond_graph.h"
#include "nanocarbon/annealing/steric_contacts.h"
#include "nanocarbon/annealing/surface_tether.h"

namespace nanocarbon::annealing {

//! What acts on a molecule beside its bonds; see FixedBondModel.
struct HeldMolecule {
  const FixedBondGraph& graph;
  const StericContacts& contacts;        //!< as of the positions
  std::span<const TangentPlane> planes;  //!< one for each atom, or none
  double tether = 0;                     //!< eV/Angstrom^2
  double mean_height = 0;                //!< Angstrom, where the tether is at rest
  std::span<const TangentPlane> edges = {};
  double reach = 0;
};

struct LocalRelaxation {
  std::size_t pieces = 0;  //!< that were relaxed
  std::size_t moved = 0;   //!< atoms of these
};

//! \brief Relaxes what is around some atoms, piece by piece, while the rest is held: bonds, guards, contacts, tether.
//! \details In a large molecule a few places come to rest long after the others. A step of the whole is no longer than
//! the worst of them allows, and costs as much for one place as for all. No bond feels two
//! pieces, and contacts between pieces see the other one where it was: threads share them out, with the same result for any
//! number. The energy of each piece does not rise; that of contacts between two pieces may. Nothing is done where that were much of the molecule.
//! \param forced atoms that feel a force, ascending
//! \param force_tolerance that pieces are relaxed to, eV/Angstrom
//! \pre in free space
LocalRelaxation relax_around(const HeldMolecule& whole, std::vector<Vec3>& positions,
                             std::span<const AtomIndex> forced, double force_tolerance,
                             ThreadTeam* team = nullptr);

}  // namespace nanocarbon::annealing
