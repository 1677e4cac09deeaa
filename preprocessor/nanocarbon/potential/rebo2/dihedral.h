// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/potential/rebo2/bond_order.h"

namespace nanocarbon::rebo2 {

//! \brief S = sum over k and l of (1 - cos^2 omega_kijl) w'_ik w'_jl (1 - Sp2(cos jik)) (1 - Sp2(cos ijl)).
//! \details Brenner et al. 2002, equation 18, with LAMMPS's switch that removes near-linear angles. w' ends
//! at dihedral_cutoff_end. Triples with k = l and angles with a sine of at most 1e-9 are left out.
//! \param i a carbon;
//! \param ij its half-edge to the carbon j
double dihedral_sum(HalfEdges& edges, const Centre& i, const HalfEdge& ij, const Centre& j,
                    const Model& model);

//! Adds the derivatives of by_sum * S to the half-edges of both ends, at a fixed by_sum (eV).
void add_dihedral_derivatives(HalfEdges& edges, const Centre& i, HalfEdge& ij, const Centre& j,
                              const Model& model, double by_sum, const potential::AtomShares& shares);

}  // namespace nanocarbon::rebo2
