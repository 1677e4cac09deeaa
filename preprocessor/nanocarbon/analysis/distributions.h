// SPDX-License-Identifier: GPL-2.0-or-later
// Bonds by pair of elements, angles, and how many bonds carbon atoms have.
#pragma once

#include <vector>

#include "nanocarbon/analysis/bond_rows.h"
#include "nanocarbon/molecule/bond_statistics.h"

namespace nanocarbon::analysis {

//! Counts in bins of equal width that hold all values.
struct Histogram {
  double from = 0.0;  //!< where the first bin begins: a multiple of the width
  double width = 1.0;
  std::vector<std::size_t> counts;  //!< the first and the last above zero; empty without values
};

Histogram histogram(std::span<const double> values, double width);

//! Values with their spread.
struct Distribution {
  molecule::Spread spread;
  Histogram histogram;
};

//! Finite values only; others are left out.
Distribution distribution(std::span<const double> values, double bin_width);

struct BondDistributions {
  Distribution carbon_carbon, carbon_hydrogen, hydrogen_hydrogen;  //!< lengths, Angstrom; bins of 0.01
  Distribution angles;  //!< between the bonds of each carbon atom, degrees; bins of 1
  std::size_t carbons = 0, hydrogens = 0;
  std::vector<std::size_t> carbons_with;  //!< carbon atoms by number of bonds, those to hydrogen too

  std::size_t with(std::size_t bonds) const { return bonds < carbons_with.size() ? carbons_with[bonds] : 0; }
  //! Share of the carbon atoms that have two, three or four bonds, which are called sp, sp2 and sp3. An edge atom
  //! without hydrogen counts as sp.
  double share_with(std::size_t bonds) const {
    return carbons == 0 ? 0.0 : static_cast<double>(with(bonds)) / static_cast<double>(carbons);
  }
};

BondDistributions bond_distributions(const Molecule& molecule, const BondRows& rows);

}  // namespace nanocarbon::analysis
