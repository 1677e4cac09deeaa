// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/remeshing/thesis/vertex_stars.h"

namespace nanocarbon::thesis {

struct LowPassResult {
  double mean_move = 0.0;  //!< Angstrom, over the vertices that may move
  double max_move = 0.0;   //!< Angstrom
};

//! \brief Moves every vertex, in its tangent plane, to the weighted centre of its stars up to the k-th
//! (Algorithm 5).
//! \details A vertex of ring r has weight 1/r. All new places are found before any vertex moves; boundary
//! vertices stay. Line 5 as printed adds every neighbour to v_j; it is read as a sum that starts from zero,
//! as the text of section 4.3 has it (the centre of mass of its neighbours).
//! \param rings k, at least 1
//! \param threads to use at most; they do not change the result
LowPassResult low_pass_filter(VertexStars& stars, unsigned rings, unsigned threads = 1);

}  // namespace nanocarbon::thesis
