// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/core/vec3.h"

namespace nanocarbon::mesh {

//! \brief On which side of the plane through a, b and c the point d lies: 1 where a, b, c look
//! counter-clockwise seen from d, -1 on the other side, 0 in the plane. Exact for finite points unless
//! numbers underflow.
//! \details Filtered arithmetic, then floating-point expansions (Shewchuk, Adaptive Precision
//! Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997).
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

//! The same in the plane, for the two coordinates other than `dropped`: 1 where a, b, c turn left.
int orientation_2d(const Vec3& a, const Vec3& b, const Vec3& c, int dropped);

}  // namespace nanocarbon::mesh
