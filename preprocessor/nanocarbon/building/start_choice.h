// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace nanocarbon::building {

//! What the choice between several starts knows of a molecule released from its tether.
struct Released {
  double energy = 0;         //!< eV for each atom
  double mean_distance = 0;  //!< of the atoms to the surface, Angstrom
  double left_out = 0;       //!< mean distance of the surface to the molecule, Angstrom

  //! The larger of the two: no atom is far from the surface where a molecule leaves out part of it.
  double distance() const;
};

//! Whether the molecule lies close enough to the surface: within 1 Angstrom on average, or farther with a tether softer
//! than the default.
//! \param tether eV/Angstrom^2
bool is_near(const Released& molecule, double tether);

//! \brief What the choice goes by among molecules that are near, or among those that are not: eV for each atom, with the
//! price of distance.
double cost(const Released& molecule, double tether);

//! \brief Whether one molecule is the better choice.
//! \details Near molecules come first. Of two that are both near, or both not, the one with less energy is better; distance
//! beyond 1 Angstrom adds to the energy. With a stiffer tether this begins closer to the surface and adds more.
bool is_better(const Released& one, const Released& other, double tether);

}  // namespace nanocarbon::building
