// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! \brief Sews boundaries that nearly coincide, as rounding and programs for CAD leave them.
//! \details Vertices on boundaries join when they are closer than a tolerance, and a vertex that lies on the
//! boundary edge of another face (a T-junction) becomes a corner of that face. The tolerance is 1e-6, 1e-5 and
//! 1e-4 of the bounding box's diagonal, one after the other, and never more than a hundredth of the median
//! boundary edge. Each step is kept only where it leaves fewer boundary edges, makes no edge and no vertex
//! non-manifold that was not, and makes no face repeat a vertex.
//! \return what was done, or nothing
std::optional<std::string> sew_boundaries(PolygonSoup& soup);

}  // namespace nanocarbon::mesh
