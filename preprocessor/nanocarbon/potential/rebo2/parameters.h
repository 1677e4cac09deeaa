// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>

#include "nanocarbon/core/element.h"
#include "nanocarbon/potential/rebo2/coordination_tables.h"

namespace nanocarbon::rebo2 {

//! The index of a pair's parameters: 0 for C-C, 1 for C-H, 2 for H-H.
constexpr std::size_t pair_index(Element a, Element b) {
  return static_cast<std::size_t>(a) + static_cast<std::size_t>(b);
}

//! Two-body parameters of one pair of elements (tables 2 and 6 of Brenner et al. 2002).
struct PairParameters {
  double cutoff_begin;                     //!< r_min: the bond is whole up to here, Angstrom
  double cutoff_end;                       //!< r_max: no bond from here on, Angstrom
  double dihedral_cutoff_end;              //!< the same for an end of a dihedral, Angstrom
  double screening;                        //!< Q of the repulsion (1 + Q/r) A exp(-alpha r), Angstrom
  double repulsion;                        //!< A, eV
  double repulsion_decay;                  //!< alpha, 1/Angstrom
  std::array<double, 3> attraction;        //!< B_n of the attraction -sum B_n exp(-beta_n r), eV
  std::array<double, 3> attraction_decay;  //!< beta_n, 1/Angstrom
  double equilibrium;                      //!< rho in lambda of angles at hydrogen, Angstrom
};

//! The strengths of AIREBO's torsion energy, eV, by pair_index() of the elements of a dihedral's ends.
struct TorsionBarriers {
  std::array<double, 3> barriers;  //!< C-CC-C, C-CC-H, H-CC-H
};

//! A quintic in cos(theta): coefficients of ascending powers.
using Quintic = std::array<double, 6>;

//! The angular function at a carbon: knots, and a branch for few and for many neighbours.
struct CarbonAngles {
  std::array<double, 5> knots;  //!< in cos(theta)
  std::array<Quintic, 4> many;  //!< G_C, used if the coordination is many_begin or more
  std::array<Quintic, 4> few;   //!< gamma_C, used if it is few_end or less
  double few_end;               //!< coordination without the bond's other end
  double many_begin;
};

//! The angular function at a hydrogen.
struct HydrogenAngles {
  std::array<double, 4> knots;
  std::array<Quintic, 3> pieces;
};

//! \brief Every parameter of REBO2: those that a potential file can set, and the splines over coordination
//! numbers.
//! \details D. W. Brenner, O. A. Shenderova, J. A. Harrison, S. J. Stuart, B. Ni, S. B. Sinnott, J. Phys.:
//! Condens. Matter 14, 783 (2002), with the angular splines of S. J. Stuart, A. B. Tutein, J. A. Harrison, J.
//! Chem. Phys. 112, 6472 (2000), as LAMMPS's CH.rebo has them, rounding included.
struct Rebo2Parameters {
  std::array<PairParameters, 3> pairs;  //!< by pair_index()
  double conjugation_begin;             //!< neighbours with fewer bonds are fully unsaturated (F = 1)
  double conjugation_end;               //!< with more they are saturated (F = 0)
  CarbonAngles carbon;
  HydrogenAngles hydrogen;
  CoordinationTables tables;  //!< not set by any file
};

//! Energy per atom of a flat, relaxed sheet of graphene (bonds of 1.42040 Angstrom), eV.
inline constexpr double graphene_energy = -7.3949972517;

//! A sixth of the energy of benzene, -59.3095690720 eV from LAMMPS, less an atom of graphene; eV.
inline constexpr double hydrogen_energy = -59.3095690720 / 6 - graphene_energy;

//! The published parameters.
const Rebo2Parameters& rebo2_parameters();

//! The linear-angle switch of dihedrals runs over these cosines (Stuart et al. 2000).
inline constexpr double linear_angle_begin = -1.0;
inline constexpr double linear_angle_end = -0.995;

//! LAMMPS drops terms whose weight, sine or torsion constant is at most this.
inline constexpr double negligible = 1e-9;

}  // namespace nanocarbon::rebo2
