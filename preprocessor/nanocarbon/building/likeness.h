// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::building {

//! \name Beyond the first of each there is a warning, beyond the second a molecule is not the shape.
//! @{
//! Mean distance of the atoms from the surface over the shape's radius, where it is above so many Angstrom, too.
inline constexpr double distance_share_to_warn = 0.10, distance_to_warn = 1.5;
inline constexpr double distance_share_to_refuse = 0.25, distance_to_refuse = 3.0;
//! Energy above graphene over what the surface's curvature and boundary cost, where it is above so many eV an
//! atom, too.
inline constexpr double energy_share_to_warn = 4.0, energy_to_warn = 0.15;
inline constexpr double energy_share_to_refuse = 8.0, energy_to_refuse = 0.40;
//! @}

//! How much a molecule is the shape that it was made for.
struct Likeness {
  double shape_radius = 0;     //!< of the sphere with the surface's area, Angstrom
  double distance = 0;         //!< mean of the atoms from the surface, Angstrom
  double distance_share = 0;   //!< the distance over the radius
  double energy = 0;           //!< above graphene, eV an atom
  double expected_energy = 0;  //!< what the surface costs an atom above graphene, by expected_energy(), eV
  double energy_share = 0;     //!< the energy over that

  bool far() const;       //!< beyond the second limit of distance
  bool strained() const;  //!< beyond the second limit of energy
  //! A sentence for each first limit that is passed.
  std::vector<std::string> warnings() const;
};

//! \brief What sp2 carbon on a surface costs above graphene, for each of a number of atoms. eV.
//!
//! Bending, 1.4 eV / 2 times the square of the curvatures' sum over the area; 5 eV for each pi/3 of Gaussian
//! curvature of either sign, which asks for a pentagon or heptagon and strains the sheet around it; 1.5 eV for
//! each Angstrom of boundary, where bonds dangle. Curvatures are those of normals smoothed over a ring, since a
//! crease is rounded to about that.
double expected_energy(const TriangleMesh& surface, std::size_t atoms);

//! \param surface Angstrom, of the size that fits the molecule
//! \param energy above graphene, eV an atom
Likeness likeness(const Molecule& molecule, const TriangleMesh& surface, double energy);

}  // namespace nanocarbon::building
