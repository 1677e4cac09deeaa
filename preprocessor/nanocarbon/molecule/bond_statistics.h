// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::molecule {

//! Minimum, mean, maximum and standard deviation (of the whole set, not of a sample); zeros when it is empty.
struct Spread {
  std::size_t count = 0;
  double min = 0.0, mean = 0.0, max = 0.0, deviation = 0.0;
};

Spread spread(std::span<const double> values);

//! An interval that values should lie in, both ends included. The default is that of bonds, Angstrom; edges
//! of a triangulation use it times sqrt(3).
struct Interval {
  double low = 1.2;
  double high = 1.8;
};

//! How values lie in and around an interval.
struct LengthStatistics {
  Spread lengths;
  std::size_t below = 0, above = 0;  //!< values below and above the interval
  double fraction_outside = 0.0;
  //! Counts in bins of equal width over the interval; values below and above it are in `below` and `above`
  //! alone.
  std::vector<std::size_t> histogram;
};

//! \param bins number of bins of the histogram, at least one
LengthStatistics length_statistics(std::span<const double> lengths, const Interval& interval = {},
                                   std::size_t bins = 24);

//! Length of each bond, Angstrom, in the order of the molecule's bonds.
std::vector<double> bond_lengths(const Molecule& molecule);

//! The angles between all pairs of bonds of one atom, degrees, atom by atom. An sp2 sheet has 120 everywhere.
std::vector<double> bond_angles(const Molecule& molecule);

}  // namespace nanocarbon::molecule
