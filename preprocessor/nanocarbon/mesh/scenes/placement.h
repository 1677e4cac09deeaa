// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! Where an object of a scene stands: x is at linear * x + translation there.
using Placement = Eigen::Affine3d;

//! \brief Adds an object to a soup where it stands. Its faces are turned where the placement is a reflection.
//! \return false where a coordinate is not finite or too large then; the soup is to be thrown away
bool add_placed(PolygonSoup& to, const PolygonSoup& object, const Placement& placement);

}  // namespace nanocarbon::mesh
