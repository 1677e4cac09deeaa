// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! \brief Joins coincident vertices along boundaries, where a mesh has been cut open or into single faces by
//! its format.
//! \details Vertices at exactly the same place are joined when both are on a boundary and what comes of it is
//! manifold (or when no face shared a vertex before, so that the file says nothing of its own). In a format
//! without vertex numbers, STL, vertices on a boundary also join when they are closer than 1e-6 of the
//! bounding box's diagonal and a hundredth of the median boundary edge, if that closes boundaries and makes
//! nothing non-manifold.
//! \return what was done, or nothing
std::optional<std::string> join_seams(PolygonSoup& soup);

}  // namespace nanocarbon::mesh
