// SPDX-License-Identifier: GPL-2.0-or-later
// Schwarzites of any size on the surfaces P, D and G.
#pragma once

#include <array>
#include <string>

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::structures {

//! \brief A schwarzite by the letter of its surface and the number of atoms in its cell: p192, d168, g384.
//! \details The Goldberg-Coxeter subdivision, T = h^2 + h k + k^2 times as many atoms, of a network without hexagons
//! beside hexagons: of hexagons and octagons on P (48 T atoms in a cube), D (48 T in the primitive cell of the fcc
//! lattice) and G (96 T in a cube), or of heptagons on D (56 T in the primitive cell of fcc). Of several (h, k) the one
//! with the largest h. Published ones: P192, D192 and G384 (8bal; Mackay and Terrones, Nature 352, 762 (1991)), D168
//! (Vanderbilt and Tersoff 1992). Near equilibrium: evened out by springs, and moved at random by up to 0.02 Angstrom
//! off its symmetry, which a minimisation would keep even where it is no minimum; the networks themselves (T = 1) as in
//! schwarzite.h.
//! \throw UserError (usage) for other names, and more than a million atoms
Molecule schwarzite(const std::string& name);

//! Several cells of a periodic structure as one; its rings are found again, of at most 8 atoms.
//! \param cells along each edge, from 1
Molecule repeated(const Molecule& molecule, const std::array<int, 3>& cells);

}  // namespace nanocarbon::structures
