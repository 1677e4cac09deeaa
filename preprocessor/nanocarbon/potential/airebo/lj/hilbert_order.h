// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/core/vec3.h"

namespace nanocarbon::airebo {

//! \brief The points' indices in the order in which a Hilbert curve visits them: points next to each other in it are
//! close in space.
//! \details Skilling, AIP Conf. Proc. 707, 381 (2004), 21 bits each way. Points at the same place keep their
//! order. Points that are not finite come first.
std::vector<std::uint32_t> hilbert_order(std::span<const Vec3> points);

}  // namespace nanocarbon::airebo
