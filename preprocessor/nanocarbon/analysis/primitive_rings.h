// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/analysis/ring_search.h"

namespace nanocarbon::analysis {

//! \brief Primitive rings: those that no path cuts short, so that of any two of their atoms the ring itself is a
//! shortest connection.
//! \details Also called shortest-path rings (D. S. Franzblau, Phys. Rev. B 44, 4925 (1991); K. Goetzke and
//! H.-J. Klein, J. Non-Cryst. Solids 127, 215 (1991)), found from their middle as in X. Yuan and A. N. Cormack,
//! Comput. Mater. Sci. 24, 343 (2002). Each ring is found once. A cage has long ones around its waist, which are no
//! faces: ten of 18 atoms in C60.
//! \pre no atom is crowded (crowded_atom)
RingStatistics primitive_rings(const BondRows& rows, const RingSearchOptions& options = {});

}  // namespace nanocarbon::analysis
