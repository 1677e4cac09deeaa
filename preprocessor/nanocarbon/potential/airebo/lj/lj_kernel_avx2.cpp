// SPDX-License-Identifier: GPL-2.0-or-later
// Compiled with the options for AVX2 and FMA; empty where the compiler does not make these instructions.
#include "nanocarbon/potential/airebo/lj/lj_kernels.h"

#if defined(__AVX2__) && defined(__FMA__)
#include <immintrin.h>

#define NANOCARBON_LANES 4

namespace nanocarbon::airebo {

namespace {
#include "nanocarbon/potential/airebo/lj/lj_kernel_body.h"
}  // namespace

const LjKernel* lj_kernel_avx2() {
  static const LjKernel kernel = {"avx2", group, evaluate, search};
  return &kernel;
}

}  // namespace nanocarbon::airebo

#else

namespace nanocarbon::airebo {
const LjKernel* lj_kernel_avx2() { return nullptr; }
}  // namespace nanocarbon::airebo

#endif
