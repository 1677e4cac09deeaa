// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::structures {

//! \brief Schwarzite D688 ("polybenzene 6.8^2 D"): hexagons and octagons on Schwarz's D surface, Pn-3m.
//! \details 24 atoms per primitive cubic cell, a = 6.0635 Angstrom, relaxed with REBO2. M. O'Keeffe, G. B.
//! Adams and O. F. Sankey, Phys. Rev. Lett. 68, 2325 (1992). One cell has Euler characteristic -2 and only
//! one side (a translation exchanges the two labyrinths); an even number of cells each way has two.
//! \throw UserError (usage) for fewer than one cell each way
Molecule schwarzite_d688(int cells_x, int cells_y, int cells_z);

//! \brief Schwarzite P688 ("polybenzene 6.8^2 P"): hexagons and octagons on Schwarz's P surface, Im-3m.
//! \details 48 atoms per cubic cell, a = 7.8006 Angstrom, relaxed with REBO2, Euler characteristic -4. As
//! above.
Molecule schwarzite_p688(int cells_x, int cells_y, int cells_z);

//! \brief Schwarzite G688 ("polybenzene 6.8^2 G"): hexagons and octagons on the gyroid, Ia-3d.
//! \details 96 atoms per cubic cell, a = 9.6011 Angstrom, relaxed with REBO2, Euler characteristic -8. As above.
Molecule schwarzite_g688(int cells_x, int cells_y, int cells_z);

//! \brief Schwarzite D56, fcc-(C28)2: heptagons alone on Schwarz's D surface, Fd-3.
//! \details 56 atoms per primitive cell of the face-centred cubic lattice of a = 13.1208 Angstrom, relaxed with REBO2,
//! Euler characteristic -4. Cages C28 without their hexagons are joined by six bonds each to four others: of each
//! hexagon's bonds every other is broken, as in D. Vanderbilt and J. Tersoff, Phys. Rev. Lett. 68, 511 (1992).
//! \throw UserError (usage) for fewer than one cell each way
Molecule schwarzite_d56(int cells_a, int cells_b, int cells_c);

}  // namespace nanocarbon::structures
