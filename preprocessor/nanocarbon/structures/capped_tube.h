// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>

#include "nanocarbon/molecule/molecule.h"
#include "nanocarbon/shapes/eisenstein.h"

namespace nanocarbon::structures {

//! \brief A cap for a tube: a pentagon in its middle and five around it.
//! \details The cap is unfolded around the pentagon in its middle; the pentagon i around it is at w^i
//! spoke[i], w = exp(i pi / 3). It fits the tube whose circumference is the sum of the spokes.
struct TubeCap {
  std::array<shapes::Eisenstein, 5> spoke;
  bool isolated = false;  //!< no two of its pentagons are neighbours
};

//! \brief The roundest cap of the tube (n, m), with isolated pentagons where there is one.
//! \details Known caps come out where they are round: half a C60 for (5, 5), half a C240 for (10, 10).
//! \throw UserError (usage) where there is none: tubes with n + m < 5 are too thin to be closed by six
//! pentagons
TubeCap tube_cap(int n, int m);

//! \brief A tube closed by a cap of six pentagons at both ends, in free space: a fullerene, all other rings
//! hexagons.
//! \details The second cap is the first one turned upside down. The axis is z. Bonds are brought near 1.43
//! Angstrom by springs.
//! \param length of the straight part between the caps, Angstrom; rounded to the lattice
//! \throw UserError (usage) as tube_cap(), and for a length that is not above zero
Molecule capped_tube(int n, int m, double length);

}  // namespace nanocarbon::structures
