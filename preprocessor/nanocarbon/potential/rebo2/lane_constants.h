// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "nanocarbon/potential/rebo2/kernels/lane_kernel.h"
#include "nanocarbon/potential/rebo2/parameters.h"

namespace nanocarbon::rebo2 {

//! \brief The parameters as the lane loops need them.
//! \param torsion of AIREBO's torsion energy; nullptr if not wanted
LaneConstants make_lane_constants(const Rebo2Parameters& parameters,
                                  const std::optional<TorsionBarriers>& torsion);

//! Whether the loops can evaluate these parameters: they use g's second branch only for five bonds or more.
bool lane_loops_apply(const Rebo2Parameters& parameters);

}  // namespace nanocarbon::rebo2
