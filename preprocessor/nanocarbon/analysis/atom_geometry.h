// SPDX-License-Identifier: GPL-2.0-or-later
// How the three bonds of an sp2 atom are bent: pyramidalisation and curvature.
#pragma once

#include <vector>

#include "nanocarbon/analysis/bond_rows.h"

namespace nanocarbon::analysis {

//! Values of each atom; not-a-number where they are not defined.
struct AtomGeometry {
  //! \brief Pyramidalisation angle, degrees: of atoms with three bonds.
  //! \details theta(sigma pi) - 90 of the pi-orbital axis vector, which makes equal angles with the three bonds
  //! (R. C. Haddon, J. Am. Chem. Soc. 108, 2837 (1986)). 0 in graphene, 11.64 in C60, 19.47 in a tetrahedron.
  std::vector<double> pyramidalisation;
  //! \brief Mean curvature, 1/Angstrom: of atoms whose three carbon neighbours have three bonds each.
  //! \details That of trivalent discrete surfaces (M. Kotani, H. Naito and T. Omori, Comput. Aided Geom. Des. 58, 24
  //! (2017)): the change of the normals of the neighbours, in the plane through the neighbours. Above zero where the
  //! surface bends away from its outside; where there is no outside to tell, its magnitude. 1/R on a sphere, 1/(2R)
  //! on a tube.
  std::vector<double> mean_curvature;
  std::vector<double>
      gaussian_curvature;  //!< 1/Angstrom^2, of the same atoms: 1/R^2 on a sphere, 0 on a tube
};

//! \param rings of a surface, counter-clockwise seen from outside: they tell it
//! \param oriented of each atom, whether its rings do (those of a one-sided component, or found by a search, do not)
AtomGeometry atom_geometry(const Molecule& molecule, const BondRows& rows, const Rings& rings,
                           std::span<const std::uint8_t> oriented);

}  // namespace nanocarbon::analysis
