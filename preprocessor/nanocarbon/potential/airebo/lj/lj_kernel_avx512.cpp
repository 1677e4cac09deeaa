// SPDX-License-Identifier: GPL-2.0-or-later
// Compiled with the options for AVX-512; empty where the compiler does not make these instructions.
#include "nanocarbon/potential/airebo/lj/lj_kernels.h"

#if defined(__AVX512F__) && defined(__AVX512DQ__)
#include <immintrin.h>

#define NANOCARBON_LANES 8

namespace nanocarbon::airebo {

namespace {
#include "nanocarbon/potential/airebo/lj/lj_kernel_body.h"
}  // namespace

const LjKernel* lj_kernel_avx512() {
  static const LjKernel kernel = {"avx512", group, evaluate, search};
  return &kernel;
}

}  // namespace nanocarbon::airebo

#else

namespace nanocarbon::airebo {
const LjKernel* lj_kernel_avx512() { return nullptr; }
}  // namespace nanocarbon::airebo

#endif
