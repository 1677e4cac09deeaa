// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "nanocarbon/remeshing/crystal/tiling.h"

namespace nanocarbon::crystal {

//! The valence a perfect crystal has here: 6, and 4 at a boundary.
inline int ideal_valence(const CornerTable& table, VertexIndex v) { return table.on_boundary(v) ? 4 : 6; }

//! \brief Flips every inner edge whose opposite angles sum to more than pi, until none is left or `passes`
//! are done.
//! \return flips made
std::size_t flip_to_delaunay(Tiling& tiling, int passes);

//! \brief Greedy flips that lower the sum of (valence - ideal)^2.
//! \param shape_limit no flip may make an angle whose cosine is above this
//! \return flips made
std::size_t flip_to_valences(Tiling& tiling, int passes, double shape_limit = 0.94);

}  // namespace nanocarbon::crystal
