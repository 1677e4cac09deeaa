// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "nanocarbon/potential/rebo2/kernels/lane_kernel.h"
#include "nanocarbon/potential/rebo2/parameters.h"

namespace nanocarbon::rebo2 {

//! \brief The parameters in the layout of the lane loops.
//! \param torsion AIREBO's torsion energy, if that is wanted
LaneConstants make_lane_constants(const Rebo2Parameters& parameters,
                                  const std::optional<TorsionBarriers>& torsion);

//! Whether the loops can evaluate these parameters: they take g's second branch for five bonds and more only.
bool lane_loops_apply(const Rebo2Parameters& parameters);

}  // namespace nanocarbon::rebo2
