// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

//! \file
//! \brief The inner loops of the long-range sum: one own atom with clusters of four neighbours.
//!
//! Compiled once for each instruction set, so nothing here may pull in inline functions of other headers: a
//! linker could take the copy made for the newest instructions for the whole program.
//!
//! Lengths are in units of sigma * width, width = switch_end - switch_begin of LjParameters: with
//! X = r^2 / (sigma width)^2 and q = 1 / X the switch's argument is t = sqrt(X) - begin. With m = 1 - t, slw =
//! m^2 (1 + 2 t) and d slw / dt = -6 t m. The force on i is f (x_i - x_j),
//!     Lennard-Jones: f = s q^4 m [c q^3 (2 + (2 + begin) t - 3 t^2) - (1 + (1 + begin) t - t^2)],   c = width^-6,
//!     Morse:         f = s y m [a (y - 1) m (1 + 2 t) + (y - 2) t] / sqrt(X),          y = 2^(k sqrt(X) + h).
//! The first holds outside the window as well: t is 0 before it, and m is 0 beyond.

#include <cstddef>
#include <cstdint>

namespace nanocarbon::airebo {

inline constexpr int lj_lanes = 4;

//! Four atoms that are near each other, 192 bytes; [x, y, z][lane].
struct alignas(64) LjCluster {
  double position[3][lj_lanes];  //!< Angstrom
  double force[3][lj_lanes];     //!< eV/Angstrom
};

//! \brief A cluster with some of its atoms: bits 0-3 a mask of the lanes, 4-7 the lanes that are hydrogen,
//! the rest the cluster's number.
using LjEntry = std::uint32_t;
inline constexpr int lj_kind_bit = 4;
inline constexpr int lj_number_bit = 8;
inline constexpr std::uint32_t lj_most_clusters = 1u << (32 - lj_number_bit);

//! The neighbours of one atom: entries [begin, end).
struct LjRow {
  std::uint32_t place;    //!< the atom: 4 * cluster + lane
  std::uint32_t element;  //!< the atom's, 0 carbon, 1 hydrogen
  std::uint32_t begin;
  std::uint32_t end;
};

//! Parameters of a pair by lane; the formulas are at the top.
struct LjPairLanes {
  double scale[lj_lanes];     //!< 1 / (sigma width)^2, 1/Angstrom^2
  double strength[lj_lanes];  //!< s: 24 epsilon scale / width^6, or 6 epsilon_M scale, eV/Angstrom^2
  double slope[lj_lanes];     //!< k = -alpha sigma width / ln 2
  double offset[lj_lanes];    //!< h = alpha r_eq / ln 2
};

//! The Lennard-Jones force f = q^4 m [q^3 steep(t) - well(t)] in some unit of length, with q = 1 / r^2 and t =
//! r to_switch - begin.
struct LjShape {
  double to_switch;
  double steep[3];  //!< coefficients, by power of t
  double well[3];
  double cutoff_squared;  //!< where the sum is cut hard
};

struct LjConstants {
  double begin;             //!< switch_begin / width
  double slope_to_a;        //!< a = slope_to_a * k, that is -ln 2 / 3
  LjShape scaled;           //!< in units of sigma * width, without the strength s
  LjShape carbon;           //!< of two carbons in Angstrom and eV
  LjPairLanes pair[2][16];  //!< by the own atom's element and the hydrogen lanes
};

//! What to evaluate.
struct LjData {
  const LjConstants* constants;
  LjCluster* clusters;
  const LjRow* rows;
  std::size_t row_count;
  const LjEntry* entries;  //!< each row has a multiple of the kernel's group
};

//! Rows to look through for what is in reach.
struct LjSearch {
  const LjCluster* clusters;
  double reach_squared[2][16][lj_lanes];  //!< as LjConstants::pair, Angstrom^2
  const LjRow* rows;
  std::size_t row_count;
  const LjEntry* entries;
  LjEntry padding;  //!< with an empty mask; of a cluster that is in no row
};

struct LjCounts {
  std::size_t rows;
  std::size_t entries;
};

//! Which of the loops.
struct LjVariant {
  bool morse;
  bool energy;
  bool mixed;        //!< there is hydrogen
  bool hard_cutoff;  //!< leave out what is at cutoff_squared or beyond
};

//! The loops as compiled for one instruction set.
struct LjKernel {
  const char* name;
  //! Entries that are worked on at once. Their clusters must differ.
  std::uint32_t group;
  //! Adds forces to the clusters'.
  //! \return energy in eV, 0 unless asked for
  double (*evaluate)(const LjData& data, LjVariant variant);
  //! \brief Writes the rows that have atoms in reach, without the others, padded to whole groups.
  //! \param rows, entries with room for all rows, and for all entries and a group more for each row
  LjCounts (*search)(const LjSearch& search, LjRow* rows, LjEntry* entries);
};

}  // namespace nanocarbon::airebo
