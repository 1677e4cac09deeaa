// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/kernels/sp2_kernel.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

#define NANOCARBON_LANES 2

namespace nanocarbon::rebo2 {

namespace {
#include "nanocarbon/potential/rebo2/kernels/sp2_kernel_body.h"
}  // namespace

const Sp2Kernel* sp2_kernel_baseline() {
  static const Sp2Kernel kernel = {
      "generic", {first<false>, second<false>}, {first<true>, second<true>}, lane_loops_baseline()};
  return &kernel;
}

}  // namespace nanocarbon::rebo2
