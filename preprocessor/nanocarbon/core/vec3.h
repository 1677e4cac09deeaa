// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <Eigen/Core>

namespace nanocarbon {

//! A point or a displacement. Angstrom, unless its name says mesh units.
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

}  // namespace nanocarbon
