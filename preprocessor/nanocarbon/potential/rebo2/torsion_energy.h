// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/potential/atom_shares.h"
#include "nanocarbon/potential/rebo2/half_edges.h"
#include "nanocarbon/potential/rebo2/parameters.h"

namespace nanocarbon::rebo2 {

//! \brief AIREBO's torsion energy around a bond between two carbons (Stuart et al. 2000, equations 12 and
//! 13).
//! \details w_ij times the sum over k and l of w_ik w_jl (1 - Sp2(cos jik)) (1 - Sp2(cos ijl)) barrier_kl
//! [256/405 ((1 + cos omega)/2)^5 - 1/10]. The weights are those of the bonds themselves. As in LAMMPS there is a switch
//! for linear angles, and terms with k = l or a sine of at most 1e-9 are left out. The half-edges of both ends must
//! have been added; derivatives are added to them.
//! \param i a carbon;
//! \param ij its half-edge to a carbon;
//! \param share as in add_bond_terms()
//! \return eV; each of a dihedral's atoms has a quarter of its energy and virial, as in LAMMPS
double add_torsion_energy(HalfEdges& edges, const Centre& i, HalfEdge& ij, const TorsionBarriers& barriers,
                          double share, const potential::AtomShares& shares);

}  // namespace nanocarbon::rebo2
