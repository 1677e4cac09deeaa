// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>

#include "nanocarbon/annealing/fixed_bond_graph.h"

namespace nanocarbon::annealing {

//! Where the guards begin to act: on bonds longer, and on second neighbours closer than this, Angstrom. Bonds
//! of a sound molecule end at 1.7, and the diagonals of its pentagons begin at 2.2.
inline constexpr double longest_unguarded_bond = 1.65, closest_unguarded_second_neighbours = 2.15;

//! \brief Harmonic walls that the fixed-bond energy needs: against torn bonds and against kinks.
//! \details REBO2 on fixed bonds hardly pulls on a bond that is stretched to twice its length, and has minima
//! where two neighbours of an atom lie on top of each other, since it does not know that they would bind.
//! Nothing is added for a molecule whose bonds REBO2 sees as intended.
//! \return eV; the gradient (eV/Angstrom) is added to
double add_guards(const FixedBondGraph& graph, std::span<const Vec3> positions, std::span<Vec3> gradient);

//! Those of one inner atom alone: its bonds to atoms after it, and the pairs of its neighbours.
double add_guards_at(AtomIndex atom, const FixedBondGraph& graph, std::span<const Vec3> positions,
                     std::span<Vec3> gradient);

}  // namespace nanocarbon::annealing
