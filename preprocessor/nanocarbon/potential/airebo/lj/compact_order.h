// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/core/vec3.h"

namespace nanocarbon::airebo {

//! \brief An order of points in which each run of so many, from the first on, is compact, and points that follow each
//! other are near each other.
//! \details Halves of halves, each cut across the longest edge of the box around it, until a run is left. Along a surface
//! such runs are rounder than pieces of a Hilbert curve, which leaves it and comes back. Points that are not finite
//! come last.
//! \param run from 1
//! \return the points' indices
std::vector<std::uint32_t> compact_order(std::span<const Vec3> points, std::size_t run);

}  // namespace nanocarbon::airebo
