// SPDX-License-Identifier: GPL-2.0-or-later
// How a molecule in a periodic cell comes to its defects.
#pragma once

#include <optional>

#include "nanocarbon/building/annealed_starts.h"

namespace nanocarbon::building {

//! \brief A molecule in a periodic cell without a defect, where the surface has room for one: tubes and sheets.
//! \details Annealing hardly finds it: it would have to turn the sheet as a whole.
//! \return nothing for other surfaces, and where bonds would not hold
std::optional<AnnealedStart> start_without_defects(const TriangleMesh& surface, std::size_t atoms,
                                                   const AnnealOptions& options);

//! \brief Anneals a closed surface in a periodic cell.
//! \details The defects that the surface asks for are few, and where they lie decides: several starts are annealed
//! with so few atoms that they find good places, and refined in one to three steps (of 3, 4, 7 or 9 triangles for one):
//! the one that is best once the first step has been made and it is let go. Up to 4,000 atoms starts at full size are
//! compared with it. The best is annealed shortly, in the cell as it strains it. Cells of a few hundred atoms are
//! annealed from hot at full size instead.
//! \param direct the start at full size, relaxed
BestStart best_start_in_cell(annealing::AnnealingLevel direct, const TriangleMesh& surface, std::size_t atoms,
                             const AnnealOptions& options);

}  // namespace nanocarbon::building
