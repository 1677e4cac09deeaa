// SPDX-License-Identifier: GPL-2.0-or-later
// The loops of lane_kernel.h for vectors of NANOCARBON_LANES doubles. Included once by each lane_kernel_*.cpp,
// inside whose unnamed namespace everything stays.

#include "nanocarbon/potential/rebo2/kernels/lanes_kernel_body.h"

#include "nanocarbon/potential/rebo2/kernels/lane_math_kernel_body.h"

#include "nanocarbon/potential/rebo2/kernels/lane_edges_kernel_body.h"

#include "nanocarbon/potential/rebo2/kernels/lane_centres_kernel_body.h"

#include "nanocarbon/potential/rebo2/kernels/lane_bonds_kernel_body.h"

static_assert(lane_block % lanes == 0);

constexpr LaneLoops lane_loops = {measure, centres, bonds, pull};
