// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

//! \file
//! \brief The inner loops for any carbon and hydrogen: an atom or a bond in each lane of a vector.
//!
//! Compiled once for each instruction set, so nothing here may pull in inline functions of other headers: a
//! linker could take the copy made for the newest instructions for the whole program.
//!
//! Everything is kept by half-edge, a bond seen from one end, in records of four numbers: atoms and bonds are
//! gathered into lanes by transposing records. The half-edges of an atom stand one after the other, those to
//! carbon first. A call takes atoms (or bonds) that have the same numbers of neighbours, so that lanes do the
//! same work.

#include <cstddef>
#include <cstdint>

namespace nanocarbon::rebo2 {

//! Atoms with more bonds than this are left to the general terms.
inline constexpr int lane_most_bonds = 12;
//! Numbers that belong to bonds come in blocks of this many, [block][piece][lane of the block].
inline constexpr std::size_t lane_block = 8;

//! Two-body parameters, as PairParameters.
struct LanePair {
  double cutoff_begin, inverse_window;       //!< Angstrom, 1/Angstrom: where the bond's weight is switched
  double dihedral_inverse_window, not_used;  //!< the same for an end of a dihedral
  double screening, repulsion, repulsion_decay, equilibrium;
  double attraction[4];  //!< the last is zero: parameters are whole records
  double attraction_decay[4];
};

//! The parameters as these loops need them.
struct LaneConstants {
  LanePair pairs[3];       //!< by pair_index()
  double carbon_knots[3];  //!< of g_C, the inner ones
  double few[6][8];        //!< [power][piece] of g_C
  double many[6][8];
  double few_end, many_begin;
  double hydrogen_knots[2];
  double hydrogen[6][8];     //!< g_H
  double p[2][5][5];         //!< P at whole numbers, by the other end's element
  double p_cells[2][16][4];  //!< its values at the corners of each cell, [4 N_C + N_H][2 c + h]
  double f[3][5 * 5 * 9]
          [4];  //!< value and slopes of F, by pair_index(), at [(N_ij * 5 + N_ji) * 9 + N_conj - 1]
  double t[5 * 5 * 9][4];  //!< of T
  bool torsion;            //!< whether AIREBO's torsion energy is wanted
  double barriers[3];      //!< of it, eV
};

//! Half-edges and what is known of them.
struct LaneEdges {
  const LaneConstants* constants;
  const double* positions;    //!< [atom] x, y, z and nothing, Angstrom
  const std::uint32_t* from;  //!< [edge] atoms
  const std::uint32_t* to;
  const std::uint32_t* pair;  //!< [edge] pair_index()
  double* geometry;           //!< [edge] unit vector, length
  double* weights;            //!< [edge] w, dw/dr, and the same for an end of a dihedral
  double* gradient;           //!< [edge] dE/d direction (eV), dE/d length (eV/Angstrom), weights included
  double* energies;           //!< [edge] eV of the terms at its end, or nullptr
};

//! Atoms of one element with equally many bonds.
struct LaneCentres {
  bool hydrogen;
  int carbons;                 //!< bonds to carbon
  int hydrogens;               //!< bonds to hydrogen
  bool whole;                  //!< all weights are 1
  const std::uint32_t* first;  //!< [atom] its first half-edge; padded to whole blocks with one of them
  std::size_t count;
};

//! What goes in and comes out for each bond, in blocks.
enum LaneBondPiece { lane_n_i, lane_n_j, lane_sum_i, lane_sum_j, lane_share, lane_pieces };

//! Bonds of one pair of elements, those with dihedrals with equally many arms.
struct LaneBonds {
  int pair;  //!< pair_index()
  bool dihedrals;
  bool triangles;  //!< some have the same atom at both ends
  int arms_i;      //!< neighbours of one end but the other, where there are dihedrals
  int arms_j;
  std::size_t count;           //!< the last block is filled up with bonds whose share is 0
  const std::uint32_t* edges;  //!< [bond] the half-edge from i to j
  const std::uint32_t* arms;   //!< [block][arm][lane] half-edges, those of i first
  //! \brief [block][LaneBondPiece][lane]: N_ij and N_ji, the sums whose squares enter N_conj, the share.
  //! \details Replaced by the energy's derivatives by the first four.
  double* numbers;
};

//! Energies, eV, as in EnergyParts.
struct LaneEnergy {
  double repulsive;
  double sigma_pi;
  double conjugation;
  double dihedral;
  double torsion;
};

//! The loops as compiled for one instruction set.
struct LaneLoops {
  //! Geometry and weights of half-edges. The lists must go on for a block beyond the end.
  void (*measure)(const LaneEdges& edges, std::size_t begin, std::size_t end);
  //! What add_centre_terms() does. Sets gradients.
  void (*centres)(const LaneEdges& edges, const LaneCentres& centres, LaneEnergy* energy);
  //! What add_bond_terms() does but for derivatives by numbers. Adds to gradients.
  void (*bonds)(const LaneEdges& edges, const LaneBonds& bonds, LaneEnergy* energy);
  //! \brief Adds the forces of half-edges, whose gradients are lost.
  //! \param forces [atom] x, y, z and nothing, eV/Angstrom
  void (*pull)(const LaneEdges& edges, std::size_t end, double* forces);
};

//! As of sp2_kernel.h.
const LaneLoops* lane_loops_baseline();
const LaneLoops* lane_loops_avx2();
const LaneLoops* lane_loops_avx512();

}  // namespace nanocarbon::rebo2
