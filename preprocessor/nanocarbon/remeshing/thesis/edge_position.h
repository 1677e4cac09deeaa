// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>

#include "nanocarbon/core/vec3.h"

namespace nanocarbon::thesis {

//! S of Eq. 4.1: the sum of (|v - n| - m)^2 over the neighbours n of a vertex at v. Square Angstrom.
double star_length_error(const Vec3& vertex, std::span<const Vec3> neighbours, double m);

//! \brief The place on the segment from a to b where S is least.
//! \details S has several minima along an edge: it is sampled, and the best sample refined by golden sections
//! to a thousandth of the segment. Eq. 4.1 says nothing of the place; section 3.5 has it "over the edge".
//! \return in [0, 1]; 0 at a, 1 at b. Of equal places the one nearest to the middle.
double least_error_position(const Vec3& a, const Vec3& b, std::span<const Vec3> neighbours, double m);

}  // namespace nanocarbon::thesis
