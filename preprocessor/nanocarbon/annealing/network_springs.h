// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>

#include "nanocarbon/annealing/atom_chunks.h"

namespace nanocarbon::annealing {

//! Rest lengths of graphene's springs, Angstrom.
inline constexpr double bond_rest_length = 1.42;
inline constexpr double second_neighbour_rest_length = 2.46;

//! Spring constants, eV/Angstrom^2.
struct SpringOptions {
  double bond = 30;
  double second_neighbour = 6;
};

//! \brief Harmonic springs along the bonds and between the two ends of each angle.
//! \details Softer than REBO2 and defined for any geometry: brings a raw dual into REBO2's range without
//! changing a bond.
//! \return eV; the gradient (eV/Angstrom) is added to
double add_springs(const FixedBondGraph& graph, std::span<const Vec3> positions, std::span<Vec3> gradient,
                   const SpringOptions& options = {});

//! The same by several threads.
//! \param chunks of the graph
double add_springs(const FixedBondGraph& graph, const AtomChunks& chunks, std::span<const Vec3> positions,
                   std::span<Vec3> gradient, ThreadTeam* team);

}  // namespace nanocarbon::annealing
