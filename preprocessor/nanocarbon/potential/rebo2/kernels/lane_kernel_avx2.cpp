// SPDX-License-Identifier: GPL-2.0-or-later
// Compiled with the options for AVX2 and FMA; empty where the compiler does not make these instructions.
#include "nanocarbon/potential/rebo2/kernels/lane_kernel.h"

#if defined(__AVX2__) && defined(__FMA__)
#include <immintrin.h>

#define NANOCARBON_LANES 4

namespace nanocarbon::rebo2 {

namespace {
#include "nanocarbon/potential/rebo2/kernels/lane_kernel_body.h"
}  // namespace

const LaneLoops* lane_loops_avx2() { return &lane_loops; }

}  // namespace nanocarbon::rebo2

#else

namespace nanocarbon::rebo2 {
const LaneLoops* lane_loops_avx2() { return nullptr; }
}  // namespace nanocarbon::rebo2

#endif
