// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::structures {

//! \brief The geometry of a single-walled carbon nanotube (n, m), from the graphene sheet it is rolled from.
//! \details Hamada indices: the circumference is the lattice vector n a1 + m a2, with a1 and a2 at 60
//! degrees; (n, n) is armchair, (n, 0) zigzag. (n, m) and (m, n) are mirror images.
struct TubeGeometry {
  double radius;                 //!< a sqrt(n^2 + n m + m^2) / (2 pi), Angstrom, not relaxed
  double period;                 //!< the translational period along the axis, Angstrom, not relaxed
  std::size_t atoms_per_period;  //!< 4 (n^2 + n m + m^2) / gcd(2 n + m, 2 m + n)
};

//! \pre n and m are at least 0, not both 0
TubeGeometry tube_geometry(int n, int m);

//! \brief A tube that is periodic along z, its axis. Across, the cell is not periodic, with 10 Angstrom to
//! spare.
//! \throw UserError (usage) for indices below 0, a tube thinner than (3, 0), or fewer than one period
Molecule periodic_tube(int n, int m, int periods);

//! \brief A tube in free space, cut square at both ends; atoms left with a single bond are removed.
//! \param length between the cuts, Angstrom, at least one ring of hexagons (4 Angstrom)
//! \throw UserError (usage) for indices as above or a length too short
Molecule open_tube(int n, int m, double length);

}  // namespace nanocarbon::structures
