// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "nanocarbon/core/cell.h"
#include "nanocarbon/mesh/repair/match_images.h"

namespace nanocarbon::mesh {

struct ZippedSeams {
  std::size_t added = 0;   //!< vertices
  std::size_t joined = 0;  //!< vertices that were made partners
  double farthest = 0;     //!< of partners made here, mesh units
};

//! \brief Makes boundaries meet that lie along images of others in a periodic cell but have their vertices elsewhere.
//! \details Between vertices that have partners already, from where boundaries meet at the cell's edges, and around loops
//! from where they are nearest to an image of another, the two lines are aligned as a whole (dynamic programming, in order along both): vertices near each
//! other become partners, others are given to the other side's triangles. So neither noise nor edges of other
//! lengths put them in a wrong order.
//! \param mesh in free space, 2-manifold; triangles at its boundary are cut
//! \param partners of each vertex, those on images of it; vertices that are added are behind the others
//! \param same_line lines this near to each other are the same, in the root mean square, mesh units; where edges are longer than
//! four times this, a quarter of these
//! \param corners_first vertices near a corner of the cell are looked for at corners, as where the surface goes through one,
//! before they are at edges
ZippedSeams zip_seams(TriangleMesh& mesh, Partners& partners, const Cell& cell, double same_line,
                      bool corners_first = false);

}  // namespace nanocarbon::mesh
