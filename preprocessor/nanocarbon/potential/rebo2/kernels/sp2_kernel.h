// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

//! \file
//! \brief The inner loops of the fast evaluation: three-coordinated carbon whose bonds are all whole.
//!
//! Compiled once for each instruction set, so nothing here may pull in inline functions of other headers: a
//! linker could take the copy made for the newest instructions for the whole program.
//!
//! For an atom with unit vectors u_s and lengths r_s (s = 0, 1, 2) every coordination is a whole number, P
//! and pi_RC are constants (zero unless modified) and so is T. The dihedral sum of a bond is a product of two
//! tensors,
//!     S = 4 - M_i : M_j,   M_i = sum over the other two neighbours k of a_k a_k^T / |a_k|^2,
//! a_k the part of u_k across the bond. The first pass makes the tensors, the second the energy and forces.
//! Each atom carries half of its bonds' energy and all derivatives of it by its own three vectors.
//!
//! Where AIREBO's torsion energy is wanted too, the first pass hands over the two unit vectors e_k along a_k
//! instead: as many numbers. Their products with the other end's are the cosines of the four dihedrals; S is
//! 4 minus the sum of their squares, and each adds barrier [256/405 ((1 + cos)/2)^5 - 1/10] (Stuart et al.
//! 2000, equation 13).

#include <cstddef>
#include <cstdint>

#include "nanocarbon/potential/rebo2/kernels/lane_kernel.h"

namespace nanocarbon::rebo2 {

//! Atoms are worked on in blocks of this many; per-atom arrays are laid out [block][piece][lane].
inline constexpr std::size_t sp2_block = 32;
inline constexpr std::size_t sp2_degree = 16;

//! The potential as these loops need it.
struct Sp2Constants {
  double shortest;  //!< atoms with a shorter or longer bond are outside, Angstrom
  double longest;
  double lowest_cosine;  //!< atoms with a smaller or larger cosine between bonds are outside
  double highest_cosine;
  double middle;                     //!< of the range of lengths, Angstrom
  double inverse_half_width;         //!< 1/Angstrom
  double repulsion[sp2_degree + 1];  //!< V_R and V_A as polynomials of (r - middle) * inverse_half_width, eV
  double attraction[sp2_degree + 1];
  double knots[3];  //!< of g_C, the inner ones
  double angular[4][6];
  double one_plus_p;       //!< 1 + P_CC(2, 0)
  double torsion_barrier;  //!< of four carbons, eV; for the loops with the torsion energy
};

//! What differs from bond to bond: pieces of a block's modifiers, [piece][lane].
struct Sp2Modifiers {
  double on[sp2_block];  //!< 1, or 0 for an atom that is evaluated elsewhere (or is padding)
  //! T of each bond, or 0 where the bond's own terms (the torsion energy too) are evaluated elsewhere.
  double torsion[3][sp2_block];
  double pi[3][sp2_block];  //!< pi_RC of each bond
};

//! \brief Arrays of one evaluation.
//! \details Geometry and tensors of a block are only there from its first pass to its last use, in a slot
//! that another block takes afterwards: small enough a set of slots stays in the cache. Record 3 * (slot *
//! sp2_block + lane) + s is bond s of the atom in a lane.
struct Sp2Data {
  const Sp2Constants* constants;
  const double* positions;          //!< x, y, z of every atom
  const std::uint32_t* atoms;       //!< [block][lane]
  const std::uint32_t* neighbours;  //!< [block][s][lane], atoms
  const std::uint32_t* reverses;  //!< [block][s][lane], the neighbour's record of this bond, or one of zeros
  const std::uint32_t* slots;     //!< [block]
  double* geometry;               //!< [slot][4 s + (x, y, z, r)][lane]
  double* tensors;                //!< [record][xx, yy, zz, xy, xz, yz], or two unit vectors
  std::uint32_t* outside;         //!< [block] a bit for each lane that is not in the fast case
  const Sp2Modifiers* const* modifiers;  //!< [block]
  double* forces;                        //!< x, y, z of every atom, added to
  double* edge_energies;                 //!< [block][s][lane], or nullptr
};

//! Energy of the second pass, eV, as in EnergyParts.
struct Sp2Energy {
  double repulsive;
  double sigma_pi;
  double conjugation;
  double dihedral;
  double torsion;  //!< left alone by loops without it
};

//! The two passes.
struct Sp2Loops {
  void (*first)(const Sp2Data& data, std::size_t begin_block, std::size_t end_block);
  void (*second)(const Sp2Data& data, std::size_t begin_block, std::size_t end_block, Sp2Energy* energy);
};

//! The loops as compiled for one instruction set.
struct Sp2Kernel {
  const char* name;
  Sp2Loops bond_order;    //!< the bond-order energy alone
  Sp2Loops with_torsion;  //!< AIREBO's torsion energy as well
  const LaneLoops* any;   //!< those for any carbon and hydrogen
};

//! The loops for any processor of this architecture (SSE2 on x86-64, NEON on ARM), for AVX2 with FMA, and for
//! AVX-512. The latter two are nullptr where the compiler did not make them; the processor must be asked
//! before they are run.
const Sp2Kernel* sp2_kernel_baseline();
const Sp2Kernel* sp2_kernel_avx2();
const Sp2Kernel* sp2_kernel_avx512();

}  // namespace nanocarbon::rebo2
