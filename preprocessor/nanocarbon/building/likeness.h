// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "nanocarbon/building/boundary_facts.h"
#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::building {

//! \name Above the first limit of each kind there is a warning, above the second a molecule does not have the shape.
//! @{
//! Mean distance, of the atoms from the surface or of the surface from the molecule, over the shape's radius; counts only
//! if the distance is also above so many Angstrom.
inline constexpr double distance_share_to_warn = 0.10, distance_to_warn = 1.5;
inline constexpr double distance_share_to_refuse = 0.25, distance_to_refuse = 3.0;
//! Energy above graphene over what the surface's curvature and boundary cost; counts only if the energy is also above so
//! many eV per atom.
inline constexpr double energy_share_to_warn = 4.0, energy_to_warn = 0.15;
inline constexpr double energy_share_to_refuse = 8.0, energy_to_refuse = 0.40;
//! The larger mean distance over the shape's mean distance from a sphere: at 1 a sphere would be as like. Counts only where
//! the shape is no sphere: where that is more than so much of its radius.
inline constexpr double roundness_to_warn = 0.50, roundness_share = 0.05;
//! Share of the surface that faces another way than the molecule does there. Of gears whose teeth became a smooth rim,
//! 0.26 to 0.47; where teeth are there, 0.08, as of other shapes up to 0.13.
inline constexpr double turned_away_to_warn = 0.20;
//! @}

//! How well a molecule has the shape of its surface.
struct Likeness {
  double shape_radius = 0;    //!< of the sphere with the surface's area, Angstrom
  double distance_there = 0;  //!< mean distance of the atoms from the surface, Angstrom
  double distance_back = 0;   //!< mean distance of the surface from the molecule, Angstrom
  double distance_share = 0;  //!< the larger of them over the radius
  double from_sphere =
      0;  //!< mean distance of the surface from a sphere about its middle, Angstrom; in cells 0
  //! Share of the surface's area where the nearest place of the molecule is turned by more than 60 degrees: the sides of
  //! teeth and grooves that it lacks. A rounded edge turns by half the edge's angle.
  double turned_away = 0;
  double energy = 0;           //!< above graphene, eV per atom
  double expected_energy = 0;  //!< of the surface above graphene, by expected_energy(), eV per atom
  double energy_share = 0;     //!< the energy over that

  double distance() const;  //!< the larger of the two, Angstrom
  //! "the atoms lie 2.0 A from the surface on average, 12% of ...": of the larger of the two distances.
  std::string distance_told() const;
  bool far() const;           //!< above the second limit of distance
  bool strained() const;      //!< above the second limit of energy
  bool rounded() const;       //!< above the limit of roundness
  bool lacks_detail() const;  //!< above the limit of what is turned away
  //! A sentence for the first limit of distance, roundness and what is turned away that is exceeded, and one for that of
  //! energy.
  std::vector<std::string> warnings() const;
};

//! \brief An estimate of the energy of sp2 carbon on a surface, eV above graphene for each atom.
//!
//! Bending: 1.4 eV / 2 times the squared sum of the principal curvatures, or of their difference where they have one sign,
//! integrated over the area. Disclinations: for each pi/3 of Gaussian curvature a pentagon or heptagon, whose cost grows
//! with the logarithm of the area that it has for itself: 2.8 eV for a pentagon of C60, 4.5 of C540, 0.9 for a heptagon on
//! the smallest schwarzites, 2.8 on those ten times as large; or less, where there is so little Gaussian curvature that a
//! strained sheet costs less. Boundary: for each Angstrom 1.2 eV where bonds dangle and 0.01 with hydrogen, for corners.
//! The curvatures are those of normals smoothed over a ring, since a crease is rounded to about that width. Molecules of
//! open surfaces, which may unbend, come to lie below it: a hemisphere of 1,000 atoms at half.
double expected_energy(const TriangleMesh& surface, std::size_t atoms,
                       Boundary boundary = Boundary::hydrogen);

//! \param molecule carbon alone, with its rings
//! \param surface Angstrom, of the size that fits the molecule
//! \param energy above graphene, eV per atom
Likeness likeness(const Molecule& molecule, const TriangleMesh& surface, double energy,
                  Boundary boundary = Boundary::hydrogen);

}  // namespace nanocarbon::building
