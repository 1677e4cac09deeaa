// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

struct DroppedFolds {
  std::size_t of_fins = 0;    //!< faces of parts folded flat upon themselves, and of walls between solids
  std::size_t of_sheets = 0;  //!< second sides of sheets that were there once for each side
};

//! \brief Drops faces that lie on others with the same vertices and face the other way.
//! \details Where such a part hangs on edges that have their two faces without it, both copies go: a fin, or
//! the wall between two solids that share it, which become one. Where what is left has one face or none there,
//! one copy stays: a sheet given for both of its sides. Anything else stays as it is.
DroppedFolds drop_folds(PolygonSoup& soup);

}  // namespace nanocarbon::mesh
