// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <span>

#include "nanocarbon/annealing/atom_chunks.h"

namespace nanocarbon::annealing {

//! \brief Energy of a harmonic spring between two points, k/2 (r - rest)^2, in eV.
//! \param a,b,rest Angstrom; points on each other pull nowhere
//! \param stiffness k, eV/Angstrom^2
//! \param at_a,at_b gradients at the points, eV/Angstrom, that the spring's are added to
inline double add_harmonic_pair(const Vec3& a, const Vec3& b, double rest, double stiffness, Vec3& at_a,
                                Vec3& at_b) {
  const Vec3 d = b - a;
  const double r = std::max(d.norm(), 1e-9), stretch = r - rest;
  const Vec3 force = stiffness * stretch / r * d;
  at_a -= force;
  at_b += force;
  return 0.5 * stiffness * stretch * stretch;
}

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
