// SPDX-License-Identifier: GPL-2.0-or-later
// Compiled with the options for AVX-512; empty where the compiler does not make these instructions.
#include "nanocarbon/potential/rebo2/kernels/sp2_kernel.h"

#if defined(__AVX512F__) && defined(__AVX512DQ__)
#include <immintrin.h>

#define NANOCARBON_LANES 8

namespace nanocarbon::rebo2 {

namespace {
#include "nanocarbon/potential/rebo2/kernels/sp2_kernel_body.h"
}  // namespace

const Sp2Kernel* sp2_kernel_avx512() {
  static const Sp2Kernel kernel = {
      "avx512", {first<false>, second<false>}, {first<true>, second<true>}, lane_loops_avx512()};
  return &kernel;
}

}  // namespace nanocarbon::rebo2

#else

namespace nanocarbon::rebo2 {
const Sp2Kernel* sp2_kernel_avx512() { return nullptr; }
}  // namespace nanocarbon::rebo2

#endif
