// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/lj/lj_kernels.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

#define NANOCARBON_LANES 2

namespace nanocarbon::airebo {

namespace {
#include "nanocarbon/potential/airebo/lj/lj_kernel_body.h"
}  // namespace

const LjKernel* lj_kernel_baseline() {
  static const LjKernel kernel = {"generic", group, evaluate, search};
  return &kernel;
}

}  // namespace nanocarbon::airebo
