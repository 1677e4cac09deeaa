// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/kernels/lane_kernel.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

#define NANOCARBON_LANES 2

namespace nanocarbon::rebo2 {

namespace {
#include "nanocarbon/potential/rebo2/kernels/lane_kernel_body.h"
}  // namespace

const LaneLoops* lane_loops_baseline() { return &lane_loops; }

}  // namespace nanocarbon::rebo2
