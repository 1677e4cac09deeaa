// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace nanocarbon::building {

//! A molecule that is let go, as far as the choice between several starts goes.
struct Released {
  double energy = 0;         //!< eV for each atom
  double mean_distance = 0;  //!< of the atoms to the surface, Angstrom
};

//! Whether the atoms lie as near to the surface as they should: within 1 Angstrom in the mean, or more under
//! a tether softer than the default.
//! \param tether eV/Angstrom^2
bool is_near(const Released& molecule, double tether);

//! \brief Whether one molecule is the better choice.
//! \details What is near comes first. Of two that are, or are not, the one with less energy is better, but
//! for a price of distance beyond 1 Angstrom; under a stiffer tether beyond less, and a higher one.
bool is_better(const Released& one, const Released& other, double tether);

}  // namespace nanocarbon::building
